// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The ground that a shore has shaped, and where it has: elsewhere a land is the same function of
// the place as without a shore, to the bit.
//
// A shore is shaped on a grid that is finer than the land's own by a power of two. Levels down to
// the land's own grid take its samples unfiltered; coarser levels are filtered as the land's levels
// are, so that both agree where the shore changed nothing nearby.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "field/spline_grid.hpp"
#include "ocean/domain.hpp"
#include "ocean/page_vector.hpp"
#include "ocean/thread_pool.hpp"

namespace ocean {

class ShoreGround {
  public:
    /// Takes the heights of a domain before and after, whose grid is finer than the land's by
    /// 2^levels.
    ShoreGround(const Domain& domain, std::span<const float> before, std::span<const float> after,
                int levels, ThreadPool& pool);

    /// The ground for maps of one cell.
    class Level {
      public:
        Level(const SplineGrid& heights, const PageVector<std::uint8_t>& changed)
            : heights_(heights), changed_(changed) {}

        /// Returns true if a sample of the cell around a place has changed. For a place on a sample
        /// or between two samples, these samples alone count.
        bool reaches(double x, double y) const;
        const SplineGrid& heights() const { return heights_; }

      private:
        /// Returns the samples before and after a coordinate; both are the same for a coordinate on
        /// a sample.
        std::pair<std::size_t, std::size_t> around(double at, std::size_t axis) const;

        const SplineGrid& heights_;
        const PageVector<std::uint8_t>& changed_;
    };
    /// Returns the level for maps whose samples lie `cell` apart [m].
    Level level(double cell) const;

    std::size_t bytes() const;

  private:
    SplinePyramid heights_;
    std::vector<PageVector<std::uint8_t>> changed_;  // of each level: 1 for changed samples
};

}  // namespace ocean
