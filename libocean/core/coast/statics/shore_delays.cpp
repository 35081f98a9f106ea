// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Delays: see shore_delays.hpp. The eikonal equation is solved at both edges of a band, which it
// shares with its neighbours, and in two directions of a sector. Four delays tau give the affine
// map of the band and sector, with k the edges' wavenumbers, G = k tau:
//   g1 = (G_high - G_low) / ((k_high - k_low) cos a)     delay along the sector's centre [m]
//   g2 = mean over k of (tau_+ - tau_-) / (2 sin a)      delay across it [m]
//   G(k) = G_0 + g1 (k . c - k_c) + g2 k . t             k_c = mean k cos a, G_0 the mean of four
// so that D = g1 c + g2 t and P = G_0 - g1 k_c. The directions lie at c +- a, a the half width over
// sqrt 3, the nodes of Gauss and Legendre: an affine map through them has the least error over the
// sector.
#include "shore_delays.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>

#include "eikonal.hpp"
#include "field/grid_blur.hpp"
#include "slowness.hpp"

namespace ocean {
namespace {

constexpr double kFeltLength = 6.0;  // [m]
constexpr double kLeastFeltCells = 1.5;
constexpr int kSides = 2;
constexpr double kNode = 0.5 * kSectorWidth / std::numbers::sqrt3;  // a [rad]

/// One eikonal solve.
struct Solve {
    int edge;
    PlaneVector direction;
};

/// The solves that the waves need, each once.
struct SolvePlan {
    std::vector<Solve> solves;
    std::array<std::array<std::array<int, kSides>, kShoreSectors>, kShoreBands + 1> index;

    explicit SolvePlan(const ShoreBands& bands) {
        for (auto& sectors : index) {
            for (auto& sides : sectors) sides.fill(-1);
        }
        for (const ShoreWaves& waves : bands.waves) {
            for (const int edge : {waves.band, waves.band + 1}) {
                for (int side = 0; side < kSides; ++side) add(edge, waves.sector, side);
            }
        }
    }

    int& at(int edge, int sector, int side) {
        return index[static_cast<std::size_t>(edge)][static_cast<std::size_t>(sector)]
                    [static_cast<std::size_t>(side)];
    }

  private:
    void add(int edge, int sector, int side) {
        int& at_index = at(edge, sector, side);
        if (at_index >= 0) return;
        at_index = static_cast<int>(solves.size());
        const double angle = sector_centre(sector) + (side == 0 ? -kNode : kNode);
        solves.push_back({edge, {std::cos(angle), std::sin(angle)}});
    }
};

/// Weights of the binomial kernel of 9 samples, whose variance is 2.
constexpr std::array<float, 9> kKernel = {1.0f / 256,  8.0f / 256,  28.0f / 256,
                                          56.0f / 256, 70.0f / 256, 56.0f / 256,
                                          28.0f / 256, 8.0f / 256,  1.0f / 256};
constexpr int kKernelReach = 4;

/// Writes the weighted sums of kKernel.size() arrays of `count` numbers, a vector of them at once.
void weigh(const std::array<const float*, kKernel.size()>& arrays, std::size_t count, float* sums) {
    constexpr std::size_t kLanes = 16;
    std::size_t k = 0;
    for (; k + kLanes <= count; k += kLanes) {
        std::array<float, kLanes> sum{};
        for (std::size_t n = 0; n < kKernel.size(); ++n) {
            for (std::size_t l = 0; l < kLanes; ++l) sum[l] += kKernel[n] * arrays[n][k + l];
        }
        std::copy(sum.begin(), sum.end(), sums + k);
    }
    for (; k < count; ++k) {
        sums[k] = 0.0f;
        for (std::size_t n = 0; n < kKernel.size(); ++n) sums[k] += kKernel[n] * arrays[n][k];
    }
}

/// Smooths a map along x, then along y, in place. Beyond its ends a line continues by its
/// reflection in the end point, so that linear maps stay unchanged.
void smooth(std::vector<float>& map, const SampleGrid& grid) {
    const auto columns = static_cast<std::size_t>(grid.columns);
    const auto reach = static_cast<std::size_t>(kKernelReach);
    std::array<const float*, kKernel.size()> arrays;
    std::vector<float> line(columns + 2 * reach);
    for (int j = 0; j < grid.rows; ++j) {
        float* const row = map.data() + grid.index(0, j);
        std::copy_n(row, columns, line.data() + reach);
        for (std::size_t k = 1; k <= reach; ++k) {
            const std::size_t mirrored = std::min(k, columns - 1);
            line[reach - k] = 2.0f * row[0] - row[mirrored];
            line[reach + columns - 1 + k] = 2.0f * row[columns - 1] - row[columns - 1 - mirrored];
        }
        for (std::size_t n = 0; n < arrays.size(); ++n) arrays[n] = line.data() + n;
        weigh(arrays, columns, row);
    }
    std::vector<float> rows(columns * (static_cast<std::size_t>(grid.rows) + 2 * reach));
    const auto kept = [&](int j) { return &rows[columns * (reach + static_cast<std::size_t>(j))]; };
    std::copy(map.begin(), map.end(), kept(0));
    const auto mirror = [&](int end, int inwards) {
        for (int k = 1; k <= kKernelReach; ++k) {
            const float* const at = kept(end);
            const float* const inside = kept(end + inwards * std::min(k, grid.rows - 1));
            float* const beyond =
                rows.data() + columns * static_cast<std::size_t>(kKernelReach + end - inwards * k);
            for (std::size_t i = 0; i < columns; ++i) beyond[i] = 2.0f * at[i] - inside[i];
        }
    };
    mirror(0, 1);
    mirror(grid.rows - 1, -1);
    for (int j = 0; j < grid.rows; ++j) {
        for (std::size_t n = 0; n < arrays.size(); ++n) {
            arrays[n] = rows.data() + columns * (static_cast<std::size_t>(j) + n);
        }
        weigh(arrays, columns, map.data() + grid.index(0, j));
    }
}

/// Returns the delays of one solve [m], smoothed by 1.4 cells: differences of first order leave
/// kinks of a cell.
std::vector<float> smoothed_delays(const EikonalSolver& solver, const SampleGrid& grid,
                                   double cell) {
    std::vector<float> delays(grid.count());
    for (int j = 0; j < grid.rows; ++j) {
        for (int i = 0; i < grid.columns; ++i) {
            delays[grid.index(i, j)] = static_cast<float>(cell * solver.delay(i, j));
        }
    }
    smooth(delays, grid);
    return delays;
}

/// The slowness, over the grid, of each edge that the waves need; other edges are empty.
std::array<std::vector<float>, kShoreBands + 1> slowness_maps(const BedGrid& depth,
                                                              const ShoreBands& bands,
                                                              const Water& water,
                                                              ThreadPool& pool) {
    std::array<std::vector<float>, kShoreBands + 1> maps;
    if (depth.values.empty()) return maps;
    const auto least = double{*std::min_element(depth.values.begin(), depth.values.end())};
    for (const ShoreWaves& waves : bands.waves) {
        for (const int edge : {waves.band, waves.band + 1}) {
            const auto e = static_cast<std::size_t>(edge);
            if (!maps[e].empty()) continue;
            const Slowness slowness(bands.edges[e], water, least);
            std::vector<float>& map = maps[e];
            map.resize(depth.values.size());
            pool.for_each_range(static_cast<int>(map.size()), [&](int first, int last) {
                for (auto n = static_cast<std::size_t>(first); n < static_cast<std::size_t>(last);
                     ++n) {
                    map[n] = slowness.at(double{depth.values[n]});
                }
            });
        }
    }
    return maps;
}

/// Writes the unit directions of the waves whose phase is k_c . x + G_0.
void write_directions(const std::vector<float>& mean_phase, const SampleGrid& grid, double cell,
                      PlaneVector wave, DelayMaps& maps) {
    maps.direction_x.resize(grid.count());
    maps.direction_y.resize(grid.count());
    const double length = std::hypot(wave.x, wave.y);
    for (int j = 0; j < grid.rows; ++j) {
        const int south = std::max(j - 1, 0), north = std::min(j + 1, grid.rows - 1);
        for (int i = 0; i < grid.columns; ++i) {
            const int west = std::max(i - 1, 0), east = std::min(i + 1, grid.columns - 1);
            const auto slope = [&](int i0, int j0, int i1, int j1) {
                const int steps = i1 - i0 + j1 - j0;
                const double rise =
                    double{mean_phase[grid.index(i1, j1)]} - double{mean_phase[grid.index(i0, j0)]};
                return steps > 0 ? rise / (steps * cell) : 0.0;
            };
            const double x = wave.x + slope(west, j, east, j);
            const double y = wave.y + slope(i, south, i, north);
            const double norm = std::hypot(x, y);
            const bool has_direction = norm > 1e-6 * length;
            const std::size_t at = grid.index(i, j);
            maps.direction_x[at] = static_cast<float>(has_direction ? x / norm : wave.x / length);
            maps.direction_y[at] = static_cast<float>(has_direction ? y / norm : wave.y / length);
        }
    }
}

/// The delays at the corners of a band and sector: [edge][side].
using CornerDelays = std::array<std::array<const float*, kSides>, 2>;

DelayMaps affine_maps(const CornerDelays& tau, double low, double high, int sector,
                      const SampleGrid& grid, double cell) {
    DelayMaps maps;
    for (std::vector<float>* map : {&maps.shift_x, &maps.shift_y, &maps.phase}) {
        map->resize(grid.count());
    }
    const double cx = std::cos(sector_centre(sector)), cy = std::sin(sector_centre(sector));
    const double centre = 0.5 * (low + high) * std::cos(kNode);
    const double along_scale = 0.5 / ((high - low) * std::cos(kNode));
    const double across_scale = 0.25 / std::sin(kNode);
    std::vector<float> mean_phase(grid.count());
    for (std::size_t n = 0; n < grid.count(); ++n) {
        const double lm = double{tau[0][0][n]}, lp = double{tau[0][1][n]};
        const double hm = double{tau[1][0][n]}, hp = double{tau[1][1][n]};
        const double phase_low = low * (lm + lp), phase_high = high * (hm + hp);
        const double g0 = 0.25 * (phase_low + phase_high);
        const double g1 = along_scale * (phase_high - phase_low);
        const double g2 = across_scale * (lp - lm + hp - hm);
        maps.shift_x[n] = static_cast<float>(g1 * cx - g2 * cy);
        maps.shift_y[n] = static_cast<float>(g1 * cy + g2 * cx);
        maps.phase[n] = static_cast<float>(g0 - g1 * centre);
        mean_phase[n] = static_cast<float>(g0);
    }
    write_directions(mean_phase, grid, cell, {centre * cx, centre * cy}, maps);
    return maps;
}

/// Calls body(item, thread) for all items, in batches of the pool's size, with progress reports in
/// between, which alone depend on the pool.
void run_in_batches(int count, ThreadPool& pool, const ShoreProgress& progress, double from,
                    double to, const std::function<void(int item, int thread)>& body) {
    const int batch = progress ? pool.size() : std::max(count, 1);
    for (int begin = 0; begin < count; begin += batch) {
        if (progress) progress(from + (to - from) * begin / count);
        pool.for_each_item(std::min(batch, count - begin),
                           [&](int item, int thread) { body(begin + item, thread); });
    }
}

}  // namespace

BedGrid felt_depth(const BedGrid& bed_height, double water_depth) {
    BedGrid depth{bed_height.domain, bed_height.values};
    for (float& value : depth.values) value = -value;
    const SampleGrid grid{depth.domain.samples[0], depth.domain.samples[1]};
    ThreadPool alone(1);
    GridPasses passes(alone, {}, kBlurPasses);
    blur(depth.values, grid, std::max(kFeltLength / depth.cell(), kLeastFeltCells), passes);
    const auto least = static_cast<float>(kLeastFeltDepth);
    const auto most = static_cast<float>(water_depth);
    for (float& value : depth.values) value = std::min(std::max(value, least), most);
    return depth;
}

std::vector<DelayMaps> shore_delays(const BedGrid& depth, const ShoreBands& bands,
                                    const Water& water, ThreadPool& pool,
                                    const ShoreProgress& progress) {
    constexpr double kSolved = 0.9;  // share of the work
    const SampleGrid grid{depth.domain.samples[0], depth.domain.samples[1]};
    SolvePlan plan(bands);
    const BorderSlopes border(depth);
    const auto slowness = slowness_maps(depth, bands, water, pool);
    std::vector<std::unique_ptr<EikonalSolver>> solvers(static_cast<std::size_t>(pool.size()));
    std::vector<std::vector<float>> delays(plan.solves.size());
    run_in_batches(
        static_cast<int>(delays.size()), pool, progress, 0.0, kSolved, [&](int item, int thread) {
            auto& solver = solvers[static_cast<std::size_t>(thread)];
            if (!solver) solver = std::make_unique<EikonalSolver>(grid, border);
            const Solve& solve = plan.solves[static_cast<std::size_t>(item)];
            solver->solve(slowness[static_cast<std::size_t>(solve.edge)], solve.direction);
            delays[static_cast<std::size_t>(item)] = smoothed_delays(*solver, grid, depth.cell());
        });
    solvers.clear();
    std::vector<DelayMaps> maps(bands.waves.size());
    run_in_batches(static_cast<int>(maps.size()), pool, progress, kSolved, 1.0, [&](int item, int) {
        const ShoreWaves& waves = bands.waves[static_cast<std::size_t>(item)];
        CornerDelays corners{};
        for (int e = 0; e < 2; ++e) {
            for (int side = 0; side < kSides; ++side) {
                const int at = plan.at(waves.band + e, waves.sector, side);
                corners[static_cast<std::size_t>(e)][static_cast<std::size_t>(side)] =
                    delays[static_cast<std::size_t>(at)].data();
            }
        }
        const auto b = static_cast<std::size_t>(waves.band);
        maps[static_cast<std::size_t>(item)] = affine_maps(
            corners, bands.edges[b], bands.edges[b + 1], waves.sector, grid, depth.cell());
    });
    if (progress) progress(1.0);
    return maps;
}

}  // namespace ocean
