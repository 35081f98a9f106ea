// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The bed under a march, in a grid that is turned to its direction: columns i follow each other
// along the march, rows j lie across it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "coast/bed/bed_grid.hpp"
#include "march_land.hpp"
#include "march_waves.hpp"

namespace ocean {

class ThreadPool;

/// The turned grid, which covers a domain with a column to spare at each end and kSpareRows rows on
/// each side: the bed beyond the sides is unknown, and waves come in from there as if the side's
/// row continued.
inline constexpr int kSpareRows = 16;
struct MarchGrid {
    double cell = 0.0;
    int columns = 0, rows = 0;
    std::array<double, 2> first{};  // the place of (0, 0) [m]
    std::array<double, 2> along{};  // the unit vector of the march

    static MarchGrid over(const Domain& domain, double direction, double cell);
    std::array<double, 2> place(double i, double j) const {
        return {first[0] + cell * (i * along[0] - j * along[1]),
                first[1] + cell * (i * along[1] + j * along[0])};
    }
    /// Returns the column and the row of a place [m].
    std::array<double, 2> position(const std::array<double, 2>& place) const {
        const double x = (place[0] - first[0]) / cell, y = (place[1] - first[1]) / cell;
        return {x * along[0] + y * along[1], y * along[0] - x * along[1]};
    }
    std::size_t index(int i, int j) const {
        return static_cast<std::size_t>(i) * static_cast<std::size_t>(rows) +
               static_cast<std::size_t>(j);
    }
    std::size_t size() const { return index(columns, 0); }
    /// Returns a map of this grid at a place [m], bilinear, continued beyond the grid's border.
    float read(const std::vector<float>& map, const std::array<double, 2>& place) const;
};

/// Returns the height of the bed at a place [m], bilinear, continued beyond its border.
double bed_at(const BedGrid& bed, const std::array<double, 2>& place);

/// The parts of the way from one column to the next, for breaking.
inline constexpr int kMarchParts = 4;
/// The rows to each side from which waves come within one column: from directions within 75 degrees
/// of the march's.
inline constexpr int kWayRows = 4;
/// The land about a place of a march.
struct MarchWays {
    /// The shares of the energy that the bed lets through on the straight ways to the place from
    /// the rows j - kWayRows .. j + kWayRows of the column before, in reversed order:
    /// share[kWayRows + m] is from row j - m.
    std::array<float, 2 * kWayRows + 1> share;
    /// False if the place is in water, and the next place before it, below or above is on land or
    /// behind land, so that its depth does not turn the waves here.
    bool before = true, below = true, above = true;

    /// Returns true if no land is about the place.
    bool is_open() const;
};

/// The bed under a march, [i][j]. Positions are the positions of depths in the depth tables.
struct MarchBed {
    static constexpr std::uint32_t kOpen = ~std::uint32_t{0};

    MarchGrid grid;
    std::vector<float> place;       // position at the place itself
    std::vector<float> refracting;  // position of the mean depth about the place
    std::vector<std::array<float, kMarchParts>> position;  // in the middle of each part before
    std::vector<std::array<float, kMarchParts>> depth;     // the same in [m], as waves feel it
    /// Index in `ways`, or kOpen if no land is near. Empty: there is no land.
    std::vector<std::uint32_t> way;
    std::vector<MarchWays> ways;
    /// The share of the open sea's energy that land beyond the border of the bed lets through to
    /// the first column, [bin][j]. Empty: there is no such land.
    std::vector<float> inflow;
};

/// Makes the bed of a march. `land` is the land of bed_height, and swallows the waves.
MarchBed make_march_bed(const BedGrid& bed_height, const MarchLand& land, const MarchGrid& grid,
                        const DirectionBins& bins, const DepthTables& depths, ThreadPool& pool);

}  // namespace ocean
