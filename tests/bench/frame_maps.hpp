// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The maps that a frame fills, the same for all subjects.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "huge_array.hpp"
#include "subject.hpp"
#include "waves/kernel/map_kernel.hpp"

namespace ocean::bench {

/// Displacement {-Dx, -Dy, height} and normal, interleaved by three.
class VertexMaps {
  public:
    explicit VertexMaps(int resolution);

    static SurfaceSettings settings();
    /// From row `row` of the maps on.
    std::array<MapOutput, 2> outputs(int row = 0) const;
    FieldView field(Linear field) const;
    FieldView normal(Channel channel) const;

  private:
    int resolution_;
    HugeArray<float> displacement_;
    HugeArray<float> normal_;
};

/// A plane for each linear field.
class PlanarMaps {
  public:
    PlanarMaps(int resolution, std::vector<Linear> fields);

    std::vector<MapOutput> outputs() const;
    float* plane(std::size_t index) const;
    FieldView field(Linear field) const;

  private:
    std::size_t resolution_;
    std::vector<Linear> fields_;
    HugeArray<float> planes_;
};

}  // namespace ocean::bench
