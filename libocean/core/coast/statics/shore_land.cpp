// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Maps continued onto the land: see shore_land.hpp.
#include "shore_land.hpp"

#include <algorithm>
#include <numeric>

#include "field/zero_line.hpp"
#include "march_bed.hpp"

namespace ocean {
namespace {

bool is_water(float bed_height) {
    return bed_height <= kLastWater;
}

/// Returns the water beside a crossing that is nearest to sample (i, j). The crossing lies between
/// `beside` and another sample, so that `beside` or one of its four neighbours is water.
std::uint32_t water_beside(const BedGrid& bed, const SampleGrid& grid, std::uint32_t beside, int i,
                           int j) {
    if (is_water(bed.values[beside])) return beside;
    const int x = static_cast<int>(beside) % grid.columns;
    const int y = static_cast<int>(beside) / grid.columns;
    constexpr int kOffsets[4][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
    std::uint32_t nearest = beside;
    double least = 0.0;
    for (const auto& offset : kOffsets) {
        const int u = x + offset[0], v = y + offset[1];
        if (u < 0 || u >= grid.columns || v < 0 || v >= grid.rows) continue;
        if (!is_water(bed.at(u, v))) continue;
        const double square = 1.0 * (u - i) * (u - i) + 1.0 * (v - j) * (v - j);
        if (nearest != beside && square >= least) continue;
        nearest = static_cast<std::uint32_t>(grid.index(u, v));
        least = square;
    }
    return nearest;
}

}  // namespace

std::vector<std::uint32_t> nearest_water(const BedGrid& bed_height, ThreadPool& pool) {
    const SampleGrid grid{bed_height.domain.samples[0], bed_height.domain.samples[1]};
    std::vector<std::uint32_t> nearest(grid.count());
    const auto water = std::count_if(bed_height.values.begin(), bed_height.values.end(), is_water);
    if (water == 0 || static_cast<std::size_t>(water) == grid.count()) {
        std::iota(nearest.begin(), nearest.end(), std::uint32_t{0});
        return nearest;
    }
    std::vector<float> above(grid.count()), offsets(grid.count()), distance(grid.count());
    for (std::size_t n = 0; n < above.size(); ++n) {
        above[n] = is_water(bed_height.values[n])
                       ? std::min(bed_height.values[n] - kLastWater, 0.0f)
                       : bed_height.values[n] - kLastWater;
    }
    GridPasses passes(pool, {}, kDistancePasses);
    zero_line_distance(above, grid, offsets, distance, nearest, passes);
    for (int j = 0; j < grid.rows; ++j) {
        for (int i = 0; i < grid.columns; ++i) {
            const std::size_t at = grid.index(i, j);
            nearest[at] = is_water(bed_height.values[at])
                              ? static_cast<std::uint32_t>(at)
                              : water_beside(bed_height, grid, nearest[at], i, j);
        }
    }
    return nearest;
}

void continue_onto_land(DelayMaps& maps, const BedGrid& bed_height,
                        std::span<const std::uint32_t> nearest) {
    const SampleGrid grid{bed_height.domain.samples[0], bed_height.domain.samples[1]};
    const auto columns = static_cast<std::uint32_t>(grid.columns);
    const auto continued = [](float& own, double place, float water, double water_place) {
        const double change = (place + double{own}) - (water_place + double{water});
        own = static_cast<float>(water_place - place + double{water} + kChangeOnLand * change);
    };
    for (std::size_t n = 0; n < grid.count(); ++n) {
        const std::uint32_t w = nearest[n];
        if (w == n) continue;
        const double cell = bed_height.cell();
        const double x = cell * static_cast<double>(n % columns);
        const double y = cell * static_cast<double>(n / columns);
        continued(maps.shift_x[n], x, maps.shift_x[w], cell * (w % columns));
        continued(maps.shift_y[n], y, maps.shift_y[w], cell * (w / columns));
        continued(maps.phase[n], 0.0, maps.phase[w], 0.0);
    }
}

void continue_onto_land(EnergyMaps& maps, const BedGrid& bed_height, ThreadPool& pool) {
    BedGrid bed{maps.domain, std::vector<float>(maps.domain.count())};
    const int columns = maps.domain.samples[0];
    pool.for_each_range(maps.domain.samples[1], [&](int first, int last) {
        for (int j = first; j < last; ++j) {
            for (int i = 0; i < columns; ++i) {
                bed.values[static_cast<std::size_t>(j) * static_cast<std::size_t>(columns) +
                           static_cast<std::size_t>(i)] =
                    static_cast<float>(bed_at(bed_height, maps.domain.place(i, j)));
            }
        }
    });
    maps.source = nearest_water(bed, pool);
    const std::vector<std::uint32_t>& nearest = maps.source;
    for (std::size_t n = 0; n < nearest.size(); ++n) {
        const std::uint32_t w = nearest[n];
        if (w == n) continue;
        const float ratio = std::min(static_cast<float>(kLeastFeltDepth) / -bed.values[w], 1.0f);
        for (std::vector<float>& amplitude : maps.amplitude) amplitude[n] = ratio * amplitude[w];
        maps.rms_height[n] = ratio * maps.rms_height[w];
        maps.breaking_share[n] = maps.breaking_share[w];
        maps.arrival[n] = maps.arrival[w];
        maps.group_width[n] = maps.group_width[w];
    }
}

}  // namespace ocean
