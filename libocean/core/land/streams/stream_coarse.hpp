// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The change of heights by erosion that a level hands to the next finer one.
#pragma once

#include <cstdint>
#include <span>

#include "land/streams/stream_grid.hpp"
#include "ocean/page_vector.hpp"

namespace ocean {

inline constexpr double kStartWork = 15.0;  // [ns] a cell of the finer level

/// Coarse valleys run in eight directions. A coarse cell knows a valley's position to no better
/// than its side. So the finer level reads it shifted at random, by up to kShift of a cell to each
/// side; the shift changes over two cells. Valleys then lose the grid's directions.
class CoarseHeights {
  public:
    /// Keeps heights minus start [m].
    CoarseHeights(std::uint32_t seed, const StreamGrid& grid, std::span<const float> start,
                  std::span<const float> heights);

    /// Returns the change of height at the centre of cell (i, j) of the next finer level [m],
    /// bilinear between the centres of the coarse cells.
    float change_at(int i, int j) const;

  private:
    static constexpr float kShift = 0.6f;  // [cells]
    static constexpr int kSpacing = 2;     // of the nodes of the shifts [cells]

    struct Shift {
        float x, y;  // [cells]
    };
    Shift shift_at(int i, int j) const;

    StreamGrid grid_;
    int nodes_along_;
    PageVector<float> change_;
    PageVector<Shift> shifts_;  // at nodes, row-major
};

}  // namespace ocean
