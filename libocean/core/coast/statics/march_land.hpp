// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The land of a bed as it stands in the way of waves. A square of four samples is two triangles
// with the higher diagonal between them, on which land that touches by its corners is connected:
// even the narrowest wall is closed for every way. A bilinear bed would be open at the corners of
// an oblique wall, and a way that is read at a few places would step over a narrow wall.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "coast/bed/bed_grid.hpp"
#include "coast/bed/still_water.hpp"

namespace ocean {

class MarchLand {
  public:
    /// Still water counts as land.
    MarchLand(const BedGrid& bed_height, const StillWater& still);

    bool is_empty() const { return is_empty_; }
    /// Returns true if the border of the bed has land, which is assumed to continue beyond it.
    bool is_at_border() const { return is_at_border_; }
    const Domain& domain() const { return bed_.domain; }
    double cell() const { return bed_.cell(); }
    /// Returns true if sample (i, j) lets less than all energy pass.
    bool is_shore(int i, int j) const { return bed_.at(i, j) > kDeepEnough; }
    /// Returns true if the bed at a place [m] is as high as still water.
    bool is_land(const std::array<double, 2>& place) const;

    /// Returns the share of the energy that the bed on the straight way between two places [m]
    /// lets through. Energy arrives on the first land that it meets and goes no further.
    float through(const std::array<double, 2>& from, const std::array<double, 2>& to) const;
    /// Returns true if the bed between two places [m] lets less energy through than both places
    /// themselves let pass. Water shallower than 0.15 m is not parted from the water before it.
    bool parts(const std::array<double, 2>& from, const std::array<double, 2>& to) const;

  private:
    static constexpr float kDeepEnough = -0.15f;  // passing() is 1 below it [m]

    std::array<double, 2> in_samples(const std::array<double, 2>& place) const;
    /// Returns the height of the triangles at a place [m], and far below still water where no shore
    /// is near.
    float height_at(const std::array<double, 2>& place) const;
    /// Returns the height of the triangles at a place within square (i, j) [m].
    float height(int i, int j, double x, double y) const;
    float at(int i, int j) const;
    bool has_shore(int i, int j) const;

    BedGrid bed_;
    double per_metre_;
    std::vector<std::uint8_t> shore_squares_;
    bool is_empty_ = true;
    bool is_at_border_ = false;
};

}  // namespace ocean
