// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Coarse to fine: each level begins with the heights of the coarser level, adds its own finer
// waves, and repeats tree and steady heights until they agree.
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "land/streams/stream_coarse.hpp"
#include "land/streams/stream_heights.hpp"
#include "land/streams/stream_land.hpp"
#include "ocean/error.hpp"

namespace ocean {
namespace {

constexpr int kRoundsOfCoarsest = 12;
constexpr int kRounds = 4;
constexpr double kRoundWork = kReceiverWork + 6.0 + kCountWork + kWalkWork;

/// Returns the grids from the coarsest, of at most 64 x 64 cells or with a side below 8, to the
/// finest.
std::vector<StreamGrid> levels_of(const StreamGrid& finest) {
    constexpr std::size_t kCells = 64 * 64;
    constexpr int kMinSide = 8;
    std::vector<StreamGrid> levels = {finest};
    while (levels.back().size() > kCells &&
           std::min(levels.back().columns, levels.back().rows) >= kMinSide) {
        const StreamGrid fine = levels.back();
        levels.push_back({(fine.columns + 1) / 2, (fine.rows + 1) / 2, 2.0 * fine.cell});
    }
    std::ranges::reverse(levels);
    return levels;
}

[[noreturn]] void refuse(const std::string& what) {
    throw Error(ErrorKind::invalid_value, "the land of a level " + what);
}

/// Makes the lowest cell of the border an outlet if the level has no outlet.
void ensure_outlet(const StreamGrid& grid, const StreamLevel& level,
                   std::span<std::uint8_t> directions) {
    if (std::ranges::find(directions, kOutlet) != directions.end()) return;
    CellIndex lowest = 0;
    for (int j = 0; j < grid.rows; ++j) {
        const bool is_edge = j == 0 || j == grid.rows - 1;
        for (int i = 0; i < grid.columns; i += is_edge ? 1 : std::max(1, grid.columns - 1)) {
            const CellIndex p = grid.index(i, j);
            if (level.start[p] < level.start[lowest]) lowest = p;
        }
    }
    directions[lowest] = kOutlet;
}

/// Checks a level, and writes kOutlet or kUnseen for each cell.
void set_outlets(const StreamGrid& grid, const StreamLevel& level,
                 std::span<std::uint8_t> directions, StreamWork& work) {
    const std::size_t size = grid.size();
    if (level.start.size() != size || level.uplift.size() != size || level.outlet.size() != size) {
        refuse("must have a height, an uplift and an outlet for each of its " +
               std::to_string(grid.columns) + " x " + std::to_string(grid.rows) + " cells");
    }
    work.rows(grid, 0.2 * kStartWork, [&](int first, int last) {
        constexpr float kMaxHeight = 1e5f;
        for (CellIndex p = grid.index(0, first); p < grid.index(0, last); ++p) {
            if (!(std::abs(level.start[p]) <= kMaxHeight)) {
                refuse("has a height that is not within -100000 .. 100000 m");
            }
            if (!(level.uplift[p] >= 0.0f && level.uplift[p] <= 1.0f)) {
                refuse("has an uplift that is not within 0 .. 1");
            }
            directions[p] = level.outlet[p] != 0 ? kOutlet : kUnseen;
        }
    });
    ensure_outlet(grid, level, directions);
}

/// Writes the initial heights of a level. Outlets keep their start.
void set_heights(const StreamGrid& grid, const StreamLevel& level,
                 const std::optional<CoarseHeights>& coarse,
                 std::span<const std::uint8_t> directions, std::span<float> heights,
                 StreamWork& work) {
    work.rows(grid, 0.8 * kStartWork, [&](int first, int last) {
        for (int j = first; j < last; ++j) {
            for (int i = 0; i < grid.columns; ++i) {
                const CellIndex p = grid.index(i, j);
                const bool is_land = coarse && directions[p] != kOutlet;
                heights[p] = level.start[p] + (is_land ? coarse->change_at(i, j) : 0.0f);
            }
        }
    });
}

void clear(const StreamGrid& grid, std::span<float> values, StreamWork& work) {
    work.rows(grid, 1.0, [&](int first, int last) {
        for (CellIndex p = grid.index(0, first); p < grid.index(0, last); ++p) values[p] = 0.0f;
    });
}

/// Returns the greatest of the values, at least 0.
float greatest(const StreamGrid& grid, std::span<const float> values, StreamWork& work) {
    std::vector<float> of_rows(static_cast<std::size_t>(grid.rows), 0.0f);
    work.rows(grid, 1.0, [&](int first, int last) {
        for (int j = first; j < last; ++j) {
            float& most = of_rows[static_cast<std::size_t>(j)];
            for (int i = 0; i < grid.columns; ++i) most = std::max(most, values[grid.index(i, j)]);
        }
    });
    return std::ranges::max(of_rows);
}

}  // namespace

double work_of_levels(const StreamGrid& finest) {
    double work = 0.0;
    for (const StreamGrid& grid : levels_of(finest)) {
        const bool is_first = work == 0.0;
        const int rounds = is_first ? kRoundsOfCoarsest : kRounds;
        work += static_cast<double>(grid.size()) * (kStartWork + kFloodWork + rounds * kRoundWork);
    }
    return work;
}

std::shared_ptr<StreamTree> solve_levels(const StreamSettings& settings, const StreamGrid& finest,
                                         const StreamSource& source,
                                         PageVector<std::uint32_t>& counts, StreamWork& work) {
    std::optional<CoarseHeights> coarse;
    std::shared_ptr<StreamTree> tree;
    for (const StreamGrid& grid : levels_of(finest)) {
        const StreamLevel level = source(grid.columns, grid.rows, grid.cell);
        const bool is_finest = grid.size() == finest.size();
        tree = std::make_shared<StreamTree>(grid);
        set_outlets(grid, level, tree->directions, work);
        set_heights(grid, level, coarse, tree->directions, tree->steady, work);
        flood(grid, FloodTo::carve, tree->steady, tree->directions, work);

        const SteadySlope slope(settings, grid.cell);
        PageVector<std::uint8_t> pending(grid.size());
        counts = PageVector<std::uint32_t>(grid.size());
        const int rounds = coarse ? kRounds : kRoundsOfCoarsest;
        for (int round = 0; round < rounds; ++round) {
            const bool is_last = is_finest && round == rounds - 1;
            choose_receivers(grid, settings.seed, tree->steady, tree->directions, work);
            find_donors(grid, tree->directions, tree->donors, work);
            count_cells(grid, tree->directions, tree->donors, pending, counts, work);
            tree->walk.reset();
            tree->walk =
                std::make_unique<StreamWalk>(grid, tree->directions, tree->donors, counts, work);
            if (is_last) clear(grid, tree->response, work);
            set_steady(grid, slope, *tree->walk, counts, level.uplift, tree->steady,
                       is_last ? std::span<float>(tree->response) : std::span<float>(), work);
        }
        if (!is_finest) coarse.emplace(settings.seed, grid, level.start, tree->steady);
    }
    tree->last_response = greatest(finest, tree->response, work);
    return tree;
}

}  // namespace ocean
