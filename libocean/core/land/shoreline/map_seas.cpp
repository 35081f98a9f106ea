// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Seas: see map_seas.hpp. A forest joins the runs of water in a row with the runs that they touch
// in the row below; its roots are seas.
#include "map_seas.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

namespace ocean {
namespace {

/// Samples first .. end - 1 of a row.
struct Run {
    int first;
    int end;
};

template <typename Use>
void for_each_run(const float* row, int columns, const Use& use) {
    for (int i = 0; i < columns; ++i) {
        if (row[i] > 0.0f) continue;
        const int first = i;
        while (i < columns && !(row[i] > 0.0f)) ++i;
        use(Run{first, i});
    }
}

/// Sets of runs. The root of a set is its smallest number; number 0 stands for the border.
class RunSets {
  public:
    explicit RunSets(std::size_t count) : parents_(count) {
        std::iota(parents_.begin(), parents_.end(), std::uint32_t{0});
    }

    std::uint32_t root(std::uint32_t run) {
        while (parents_[run] != run) {
            parents_[run] = parents_[parents_[run]];
            run = parents_[run];
        }
        return run;
    }
    void join(std::uint32_t a, std::uint32_t b) {
        a = root(a);
        b = root(b);
        parents_[std::max(a, b)] = std::min(a, b);
    }

  private:
    std::vector<std::uint32_t> parents_;
};

/// Joins the runs of a row, which begin at `here`, with the runs of the row below it, which begin
/// at `below`.
void join_rows(const std::vector<Run>& runs, std::uint32_t below, std::uint32_t here,
               std::uint32_t end, RunSets& sets) {
    for (std::uint32_t b = below, h = here; b < here && h < end;) {
        if (runs[b].first < runs[h].end && runs[h].first < runs[b].end) sets.join(b, h);
        if (runs[b].end < runs[h].end) {
            ++b;
        } else {
            ++h;
        }
    }
}

}  // namespace

void raise_cut_off_seas(std::span<float> map, const SampleGrid& grid) {
    std::size_t count = 1;  // the border
    for (int j = 0; j < grid.rows; ++j) {
        for_each_run(&map[grid.index(0, j)], grid.columns, [&](Run) { ++count; });
    }
    std::vector<Run> runs;
    runs.reserve(count);
    runs.push_back({0, 0});
    RunSets sets(count);
    std::uint32_t below = 1;
    for (int j = 0; j < grid.rows; ++j) {
        const auto here = static_cast<std::uint32_t>(runs.size());
        for_each_run(&map[grid.index(0, j)], grid.columns, [&](Run run) {
            const bool at_border =
                j == 0 || j == grid.rows - 1 || run.first == 0 || run.end == grid.columns;
            if (at_border) sets.join(0, static_cast<std::uint32_t>(runs.size()));
            runs.push_back(run);
        });
        join_rows(runs, below, here, static_cast<std::uint32_t>(runs.size()), sets);
        below = here;
    }
    std::uint32_t number = 1;
    for (int j = 0; j < grid.rows; ++j) {
        // The runs of a row end where the next row's begin; all were found before any sea was
        // raised.
        float* const row = &map[grid.index(0, j)];
        for_each_run(row, grid.columns, [&](Run run) {
            if (sets.root(number++) == 0) return;
            for (int i = run.first; i < run.end; ++i) {
                row[i] = std::max(-row[i], std::numeric_limits<float>::min());
            }
        });
    }
}

}  // namespace ocean
