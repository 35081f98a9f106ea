// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Start, uplift and outlets of streams; see stream_source.hpp.
#include "land/function/stream_source.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include "land/streams/stream_creep.hpp"
#include "land/streams/stream_flood.hpp"
#include "land/streams/stream_work.hpp"
#include "ocean/page_vector.hpp"
#include "ocean/terrain_table.hpp"

namespace ocean {
namespace {

constexpr double kWavesOfShore = 64.0;  // along the longer side
constexpr double kMinUplift = 0.25;     // relative, at the shore
constexpr double kFullUplift = 0.5;     // relative height from which uplift is 1
/// Heights of the start's summits over the hillslopes' summits, from the shore to the middle of the
/// land: low, so that valleys find their own way.
constexpr double kStartRelief = 0.1;
constexpr float kMinDepth = 0.5f;  // of the sea [m]

/// Heights before erosion at the cells of a level.
struct Cells {
    int columns, rows;
    std::vector<float> height;  // heights of all waves
    std::vector<float> smooth;  // heights of the waves of shore and uplift
};

Cells cells_of(const SplinePyramid& base, double offset, const Domain& domain, int columns,
               int rows, double cell, ThreadPool& pool) {
    const double longer = std::max(domain.size[0], domain.size[1]);
    const double smooth_cell = std::max(cell, 0.5 * longer / kWavesOfShore);
    const SplineGrid& all = base.level(cell);
    const SplineGrid& smooth = base.level(smooth_cell);
    const double half = 0.5 * domain.step(0);
    const auto width = static_cast<std::size_t>(columns);
    const std::size_t count = width * static_cast<std::size_t>(rows);
    Cells cells{columns, rows, std::vector<float>(count), std::vector<float>(count)};
    pool.for_each_range(rows, [&](int first, int last) {
        for (int j = first; j < last; ++j) {
            for (int i = 0; i < columns; ++i) {
                const double x = domain.origin[0] - half + (i + 0.5) * cell;
                const double y = domain.origin[1] - half + (j + 0.5) * cell;
                const auto at = static_cast<std::size_t>(j) * width + static_cast<std::size_t>(i);
                cells.height[at] = static_cast<float>(all.value_at(x, y) + offset);
                cells.smooth[at] = static_cast<float>(smooth.value_at(x, y) + offset);
            }
        }
    });
    return cells;
}

/// Returns 1 for the cells below `level` that such cells connect to the border.
std::vector<std::uint8_t> seas_of(const Cells& cells, double level) {
    std::vector<std::uint8_t> sea(cells.smooth.size());
    std::vector<std::pair<int, int>> front;
    const auto enter = [&](int i, int j) {
        if (i < 0 || j < 0 || i >= cells.columns || j >= cells.rows) return;
        const auto at = static_cast<std::size_t>(j) * static_cast<std::size_t>(cells.columns) +
                        static_cast<std::size_t>(i);
        if (sea[at] != 0 || static_cast<double>(cells.smooth[at]) >= level) return;
        sea[at] = 1;
        front.emplace_back(i, j);
    };
    for (int i = 0; i < cells.columns; ++i) {
        enter(i, 0);
        enter(i, cells.rows - 1);
    }
    for (int j = 0; j < cells.rows; ++j) {
        enter(0, j);
        enter(cells.columns - 1, j);
    }
    while (!front.empty()) {
        const auto [i, j] = front.back();
        front.pop_back();
        enter(i + 1, j);
        enter(i - 1, j);
        enter(i, j + 1);
        enter(i, j - 1);
    }
    return sea;
}

/// Rounds the floors of channels, which are one cell wide and turn by 45 degrees, so that finer
/// maps do not show them as stairs. The smoothing has a deviation of one cell; then every cell
/// drains again. `outlets` keep their heights.
void round_floors(const StreamGrid& grid, std::span<const std::uint8_t> outlets,
                  std::span<float> heights, ThreadPool& pool) {
    constexpr double kReachOfDeviation = 1.4142135623730951;
    const StreamProgress none;  // StreamWork refers to it
    StreamWork work(pool, none, 1.0);
    PageVector<std::uint8_t> directions(grid.size());
    for (std::size_t i = 0; i < grid.size(); ++i) {
        directions[i] = outlets[i] != 0 ? kOutlet : kUnseen;
    }
    const std::vector<float> no_channel(grid.size(), 0.0f);
    creep(grid, kReachOfDeviation * grid.cell, no_channel, directions, heights, work);
    flood(grid, FloodTo::drain, heights, directions, work);
}

/// The cells by which water leaves: the sea, or all cells of the border if there is no sea.
struct Outlets {
    std::vector<std::uint8_t> is_outlet;  // 1 in such a cell
    bool are_sea = false;
};

Outlets outlets_of(const Cells& cells, double level) {
    Outlets outlets{seas_of(cells, level), true};
    if (std::ranges::find(outlets.is_outlet, std::uint8_t{1}) != outlets.is_outlet.end()) {
        return outlets;
    }
    outlets.are_sea = false;
    for (int j = 0; j < cells.rows; ++j) {
        for (int i = 0; i < cells.columns; ++i) {
            const bool at_border =
                i == 0 || j == 0 || i == cells.columns - 1 || j == cells.rows - 1;
            const auto at = static_cast<std::size_t>(j) * static_cast<std::size_t>(cells.columns) +
                            static_cast<std::size_t>(i);
            if (at_border) outlets.is_outlet[at] = 1;
        }
    }
    return outlets;
}

}  // namespace

StreamSource stream_source(const TerrainModel& terrain, const SplinePyramid& base, double offset,
                           const Domain& domain, double level, ThreadPool& pool) {
    const double side = std::min(domain.size[0], domain.size[1]);
    const double summit = kStartRelief * terrain.stream.slope * 0.5 * side;
    return [&base, &pool, offset, domain, level, summit](int columns, int rows, double cell) {
        const Cells cells = cells_of(base, offset, domain, columns, rows, cell, pool);
        Outlets outlets = outlets_of(cells, level);
        const double foot =
            outlets.are_sea ? level : static_cast<double>(std::ranges::min(cells.smooth));
        StreamLevel land;
        land.outlet = std::move(outlets.is_outlet);
        const double highest =
            std::max(static_cast<double>(std::ranges::max(cells.smooth)) - foot, 1e-3);
        const double scale = std::min(1.0, summit / highest);
        land.start.reserve(cells.height.size());
        land.uplift.reserve(cells.height.size());
        for (std::size_t i = 0; i < cells.height.size(); ++i) {
            const double above = static_cast<double>(cells.height[i]) - foot;
            const double rise = (static_cast<double>(cells.smooth[i]) - foot) / highest;
            land.start.push_back(land.outlet[i] != 0
                                     ? static_cast<float>(foot)
                                     : static_cast<float>(foot + scale * std::max(above, 0.0)));
            land.uplift.push_back(static_cast<float>(
                kMinUplift + (1.0 - kMinUplift) * std::clamp(rise / kFullUplift, 0.0, 1.0)));
        }
        return land;
    };
}

std::vector<float> with_sea_bed(const StreamLand& land, const SplinePyramid& base, double offset,
                                const Domain& domain, double level, ThreadPool& pool) {
    std::vector<float> heights(land.height.begin(), land.height.end());
    const double cell = domain.step(0);
    const Cells cells =
        cells_of(base, offset, domain, domain.samples[0], domain.samples[1], cell, pool);
    const Outlets outlets = outlets_of(cells, level);
    round_floors({domain.samples[0], domain.samples[1], cell}, outlets.is_outlet, heights, pool);
    if (!outlets.are_sea) return heights;
    for (std::size_t i = 0; i < heights.size(); ++i) {
        if (outlets.is_outlet[i] == 0) continue;
        heights[i] = std::min(cells.height[i], static_cast<float>(level) - kMinDepth);
    }
    return heights;
}

bool same_streams(const TerrainModel& a, const TerrainModel& b) {
    if (a.rings != b.rings || a.base_model != b.base_model) return false;
    if (a.layers.size() != b.layers.size()) return false;
    for (const TerrainRow& row : terrain_table().rows) {
        // Detail moves the samples of a base, but no other input of the streams.
        const bool comes_later =
            (row.holds<&TerrainModel::detail_wavelength>() && a.base_model == nullptr) ||
            (row.section == "terrain.coast" && row.key != "level");
        if (comes_later) continue;
        for (std::size_t item = 0; item < row.member.items(a); ++item) {
            if (row.member.get(a, item) != row.member.get(b, item)) return false;
        }
    }
    return true;
}

}  // namespace ocean
