// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The bed under a march: see march_bed.hpp.
#include "march_bed.hpp"

#include <algorithm>
#include <cmath>

#include "field/bilinear.hpp"
#include "ocean/thread_pool.hpp"

namespace ocean {
namespace {

std::size_t at(int n) {
    return static_cast<std::size_t>(n);
}

/// The places of a march that may have land on their ways.
class NearLand {
  public:
    NearLand(const MarchLand& land, const MarchGrid& grid)
        : land_(land), grid_(grid), near_(grid.size()) {
        if (land.is_empty()) return;
        const Domain& domain = land.domain();
        const double reach = 1.5 * land.cell() / grid.cell;  // of a sample's squares [cells]
        for (int j = 0; j < domain.samples[1]; ++j) {
            for (int i = 0; i < domain.samples[0]; ++i) {
                if (land.is_shore(i, j)) mark(grid.position(domain.place(i, j)), reach);
            }
        }
    }
    bool operator()(int i, int j) const {
        return near_[grid_.index(i, j)] != 0 || (land_.is_at_border() && reaches_beyond(i, j));
    }

  private:
    /// Marks the places whose ways come near a position.
    void mark(const std::array<double, 2>& position, double reach) {
        const auto [u, v] = position;
        const int first = std::max(static_cast<int>(std::ceil(u - reach)), 0);
        const int last = std::min(static_cast<int>(std::floor(u + reach)) + 1, grid_.columns - 1);
        const int low = std::max(static_cast<int>(std::ceil(v - reach)) - kWayRows, 0);
        const int high =
            std::min(static_cast<int>(std::floor(v + reach)) + kWayRows, grid_.rows - 1);
        for (int i = first; i <= last; ++i) {
            for (int j = low; j <= high; ++j) near_[grid_.index(i, j)] = 1;
        }
    }
    /// Returns true if a way to (i, j) begins or ends beyond the bed.
    bool reaches_beyond(int i, int j) const {
        const Domain& domain = land_.domain();
        const auto is_beyond = [&](const std::array<double, 2>& place) {
            return place[0] < domain.origin[0] || place[1] < domain.origin[1] ||
                   place[0] > domain.origin[0] + domain.size[0] ||
                   place[1] > domain.origin[1] + domain.size[1];
        };
        return is_beyond(grid_.place(i, j)) || is_beyond(grid_.place(i - 1, j - kWayRows)) ||
               is_beyond(grid_.place(i - 1, j + kWayRows));
    }

    const MarchLand& land_;
    const MarchGrid& grid_;
    std::vector<std::uint8_t> near_;
};

MarchWays ways_to(const MarchLand& land, const MarchGrid& grid, int i, int j) {
    MarchWays ways;
    const std::array<double, 2> place = grid.place(i, j);
    for (int m = -kWayRows; m <= kWayRows; ++m) {
        ways.share[at(kWayRows + m)] = land.through(grid.place(i - 1, j - m), place);
    }
    if (land.is_land(place)) return ways;
    ways.before = ways.share[at(kWayRows)] > 0.0f;
    ways.below = land.through(grid.place(i, j - 1), place) > 0.0f;
    ways.above = land.through(grid.place(i, j + 1), place) > 0.0f;
    return ways;
}

/// Finds the ways of a march that land crosses.
void find_ways(const MarchLand& land, MarchBed& bed, ThreadPool& pool) {
    if (land.is_empty()) return;
    const MarchGrid& grid = bed.grid;
    const NearLand near(land, grid);
    bed.way.assign(grid.size(), MarchBed::kOpen);
    std::vector<std::vector<MarchWays>> ways(at(grid.columns));
    pool.for_each_item(grid.columns, [&](int i, int) {
        for (int j = 0; j < grid.rows; ++j) {
            if (!near(i, j)) continue;
            const MarchWays to = ways_to(land, grid, i, j);
            if (to.is_open()) continue;
            bed.way[grid.index(i, j)] = static_cast<std::uint32_t>(ways[at(i)].size());
            ways[at(i)].push_back(to);
        }
    });
    for (int i = 0; i < grid.columns; ++i) {
        const auto first = static_cast<std::uint32_t>(bed.ways.size());
        for (int j = 0; j < grid.rows; ++j) {
            std::uint32_t& way = bed.way[grid.index(i, j)];
            if (way != MarchBed::kOpen) way += first;
        }
        bed.ways.insert(bed.ways.end(), ways[at(i)].begin(), ways[at(i)].end());
    }
}

}  // namespace

bool MarchWays::is_open() const {
    return before && below && above &&
           std::ranges::all_of(share, [](float s) { return s == 1.0f; });
}

double bed_at(const BedGrid& bed, const std::array<double, 2>& place) {
    std::array<int, 2> low{};
    std::array<double, 2> share{};
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const int last = bed.domain.samples[axis] - 1;
        const double x = std::clamp((place[axis] - bed.domain.origin[axis]) / bed.cell(), 0.0,
                                    static_cast<double>(last));
        low[axis] = std::min(static_cast<int>(x), std::max(last - 1, 0));
        share[axis] = x - low[axis];
    }
    const int right = std::min(low[0] + 1, bed.domain.samples[0] - 1);
    const int top = std::min(low[1] + 1, bed.domain.samples[1] - 1);
    return bilinear(double{bed.at(low[0], low[1])}, double{bed.at(right, low[1])},
                    double{bed.at(low[0], top)}, double{bed.at(right, top)}, share[0], share[1]);
}

MarchGrid MarchGrid::over(const Domain& domain, double direction, double cell) {
    const double x = std::cos(direction), y = std::sin(direction);
    const double width = domain.size[0], height = domain.size[1];
    const double half_along = 0.5 * (width * std::abs(x) + height * std::abs(y)) + cell;
    const double half_across =
        0.5 * (width * std::abs(y) + height * std::abs(x)) + kSpareRows * cell;
    MarchGrid grid{.cell = cell, .along = {x, y}};
    grid.columns = static_cast<int>(std::ceil(2.0 * half_along / cell)) + 1;
    grid.rows = static_cast<int>(std::ceil(2.0 * half_across / cell)) + 1;
    const double back = 0.5 * cell * (grid.columns - 1), right = 0.5 * cell * (grid.rows - 1);
    grid.first = {domain.origin[0] + 0.5 * width - back * x + right * y,
                  domain.origin[1] + 0.5 * height - back * y - right * x};
    return grid;
}

float MarchGrid::read(const std::vector<float>& map, const std::array<double, 2>& place) const {
    const auto [along_march, across] = position(place);
    const double u = std::clamp(along_march, 0.0, columns - 1.0);
    const double v = std::clamp(across, 0.0, rows - 1.0);
    const int i = std::min(static_cast<int>(u), columns - 2);
    const int j = std::min(static_cast<int>(v), rows - 2);
    const auto share_u = static_cast<float>(u - i), share_v = static_cast<float>(v - j);
    return bilinear(map[index(i, j)], map[index(i, j + 1)], map[index(i + 1, j)],
                    map[index(i + 1, j + 1)], share_v, share_u);
}

/// Computes which waves land beyond the border keeps off. That land continues for the length of the
/// bed's longer side.
void find_inflow(const MarchLand& land, const DirectionBins& bins, MarchBed& bed,
                 ThreadPool& pool) {
    if (!land.is_at_border()) return;
    const MarchGrid& grid = bed.grid;
    const double beyond = std::max(land.domain().size[0], land.domain().size[1]) / grid.cell;
    bed.inflow.resize(at(bins.count) * at(grid.rows));
    pool.for_each_item(bins.count, [&](int bin, int) {
        const double along = beyond * std::cos(bins.centre(bin));
        const double across = beyond * std::sin(bins.centre(bin));
        for (int j = 0; j < grid.rows; ++j) {
            bed.inflow[at(bin) * at(grid.rows) + at(j)] =
                land.through(grid.place(-along, j - across), grid.place(0, j));
        }
    });
}

MarchBed make_march_bed(const BedGrid& bed_height, const MarchLand& land, const MarchGrid& grid,
                        const DirectionBins& bins, const DepthTables& depths, ThreadPool& pool) {
    MarchBed bed;
    bed.grid = grid;
    bed.place.resize(grid.size());
    bed.refracting.resize(grid.size());
    bed.position.resize(grid.size());
    bed.depth.resize(grid.size());
    const auto felt_depth = [&](double height) {
        return std::clamp(-height, depths.min_depth(), depths.max_depth());
    };
    find_ways(land, bed, pool);
    pool.for_each_range(grid.columns, [&](int first, int end) {
        for (int i = first; i < end; ++i) {
            for (int j = 0; j < grid.rows; ++j) {
                const std::size_t cell = grid.index(i, j);
                const std::array<double, 2> place = grid.place(i, j);
                const double here = felt_depth(bed_at(bed_height, place));
                const bool may_have_land =
                    !bed.way.empty() && bed.way[cell] != MarchBed::kOpen && !land.is_land(place);
                // Waves that come round land have not crossed its depths.
                const auto depth_at = [&](double back) {
                    const std::array<double, 2> at_part = grid.place(i - back, j);
                    return may_have_land && land.through(at_part, place) <= 0.0f
                               ? here
                               : felt_depth(bed_at(bed_height, at_part));
                };
                for (int part = 0; part < kMarchParts; ++part) {
                    const double depth = depth_at(1.0 - (part + 0.5) / kMarchParts);
                    bed.depth[cell][at(part)] = static_cast<float>(depth);
                    bed.position[cell][at(part)] = depths.position(depth);
                }
                bed.place[cell] = depths.position(here);
                bed.refracting[cell] = depths.position(
                    (double{bed.depth[cell].back()} + here + depth_at(-0.5 / kMarchParts)) / 3.0);
            }
        }
    });
    find_inflow(land, bins, bed, pool);
    return bed;
}

}  // namespace ocean
