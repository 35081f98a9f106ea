// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Lowest and highest ground in squares of a land, by which patches that the camera does not see are
// left out.
#pragma once

#include <utility>
#include <vector>

#include "ocean/internal/preview/land_maps.hpp"

namespace ocean::preview {

class HeightRanges {
  public:
    /// margin: of the ground between the samples and below their distance [m].
    HeightRanges(const LandImage& image, double margin);

    /// Returns bounds of the heights in the square with the lower left corner (x, y) [m].
    std::pair<float, float> in(double x, double y, double side) const;

  private:
    using Range = std::pair<float, float>;
    struct Level {
        int side;      // blocks along a side
        double block;  // [m]
        std::vector<Range> ranges;
    };
    static constexpr int kBlock = 8;  // samples along a side of the smallest block

    void add_finest(const LandImage& image, float margin);
    void add_coarser();

    std::array<double, 2> origin_;
    double period_;
    bool wraps_;
    std::vector<Level> levels_;
};

}  // namespace ocean::preview
