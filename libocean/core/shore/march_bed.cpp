// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The bed under a march: see march_bed.hpp.
#include "march_bed.hpp"

#include <algorithm>
#include <cmath>

#include "ocean/thread_pool.hpp"

namespace ocean {
namespace {

constexpr double kSoftShore = 0.15;  // half the rise over which land begins to swallow [m]

std::size_t at(int n) {
    return static_cast<std::size_t>(n);
}

/// Returns the share of the energy that a bed of this height lets pass.
float passing(double height) {
    return static_cast<float>(1.0 -
                              std::clamp((height + kSoftShore) / (2.0 * kSoftShore), 0.0, 1.0));
}

}  // namespace

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
    const auto along_row = [&](int j) {
        const double left = double{bed.at(low[0], j)};
        return left + share[0] * (double{bed.at(right, j)} - left);
    };
    const double bottom = along_row(low[1]);
    return bottom + share[1] * (along_row(top) - bottom);
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
    const double x = (place[0] - first[0]) / cell, y = (place[1] - first[1]) / cell;
    const double u = std::clamp(x * along[0] + y * along[1], 0.0, columns - 1.0);
    const double v = std::clamp(y * along[0] - x * along[1], 0.0, rows - 1.0);
    const int i = std::min(static_cast<int>(u), columns - 2);
    const int j = std::min(static_cast<int>(v), rows - 2);
    const auto share_u = static_cast<float>(u - i), share_v = static_cast<float>(v - j);
    const auto column = [&](int c) {
        const float low = map[index(c, j)];
        return low + share_v * (map[index(c, j + 1)] - low);
    };
    const float near = column(i);
    return near + share_u * (column(i + 1) - near);
}

MarchBed make_march_bed(const BedGrid& bed_height, const MarchGrid& grid, const DepthTables& depths,
                        ThreadPool& pool) {
    MarchBed bed;
    bed.grid = grid;
    bed.place.resize(grid.size());
    bed.refracting.resize(grid.size());
    bed.position.resize(grid.size());
    bed.depth.resize(grid.size());
    bed.before.resize(grid.size());
    bed.behind.resize(grid.size());
    const auto felt_depth = [&](double height) {
        return std::clamp(-height, depths.least_depth(), depths.greatest_depth());
    };
    pool.for_each_range(grid.columns, [&](int first, int end) {
        for (int i = first; i < end; ++i) {
            for (int j = 0; j < grid.rows; ++j) {
                const std::size_t cell = grid.index(i, j);
                float before = 1.0f;
                for (int part = 0; part < kMarchParts; ++part) {
                    const double back = 1.0 - (part + 0.5) / kMarchParts;
                    const double height = bed_at(bed_height, grid.place(i - back, j));
                    bed.depth[cell][at(part)] = static_cast<float>(felt_depth(height));
                    bed.position[cell][at(part)] = depths.position(felt_depth(height));
                    before = std::min(before, passing(height));
                }
                const double height = bed_at(bed_height, grid.place(i, j));
                const double after = bed_at(bed_height, grid.place(i + 0.5 / kMarchParts, j));
                // Land swallows what lies behind it, not what arrives on its first cell.
                const bool water = height < 0.0;
                bed.before[cell] = water ? before : 1.0f;
                bed.behind[cell] = water ? passing(height) : std::min(before, passing(height));
                bed.place[cell] = depths.position(felt_depth(height));
                bed.refracting[cell] = depths.position(
                    (double{bed.depth[cell].back()} + felt_depth(height) + felt_depth(after)) /
                    3.0);
            }
        }
    });
    return bed;
}

}  // namespace ocean
