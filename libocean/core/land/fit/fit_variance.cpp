// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The variance of a fitted tile: see fit_variance.hpp.
#include "fit_variance.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <utility>

#include "ocean/internal/grid.hpp"
#include "ocean/internal/terrain_law.hpp"
#include "ocean/internal/terrain_modes.hpp"

namespace ocean {
namespace {

constexpr int kLongWaves = 32;  // side of a tile of the long waves, in which seeds differ

TerrainAmplitudes amplitudes_of(const TerrainModel& terrain) {
    const double dk = kTwoPi / terrain.patch_size;
    return {TerrainLaw(terrain), dk, dk * terrain.resolution};
}

/// Calls visit(n, m, S dk^2) for the half plane of the waves of the tile.
template <typename Visit>
void each_wave(const TerrainModel& terrain, const Visit& visit) {
    const TerrainAmplitudes amplitude = amplitudes_of(terrain);
    const double dk = kTwoPi / terrain.patch_size;
    const int half = terrain.resolution / 2;
    std::vector<double> row(static_cast<std::size_t>(half));
    for (int m = 1 - half; m < half; ++m) {
        amplitude.row(dk, m * dk, row);
        for (int n = m > 0 ? 0 : 1; n < half; ++n) {
            const double a = row[static_cast<std::size_t>(n)] * dk;
            visit(n, m, a * a);
        }
    }
}

/// The share of a wave's energy along one side that is in the mean, and in the straight line.
struct LineShares {
    double mean = 0.0;
    double slope = 0.0;
};

/// Returns the shares of exp(i k x), k = n dk, for n = 0 .. half - 1 over `samples` samples: the
/// squares of its projections on 1 and on x from the middle.
std::vector<LineShares> line_shares(int samples, double phase_step, int half) {
    double squares = 0.0;
    for (int i = 0; i < samples; ++i) squares += std::pow(i - 0.5 * (samples - 1), 2);
    std::vector<LineShares> shares;
    for (int n = 0; n < half; ++n) {
        const std::complex<double> turn = std::polar(1.0, n * phase_step);
        std::complex<double> value = 1.0, mean = 0.0, slope = 0.0;
        for (int i = 0; i < samples; ++i, value *= turn) {
            mean += value;
            slope += value * (i - 0.5 * (samples - 1));
        }
        shares.push_back(
            {std::norm(mean) / samples / samples, std::norm(slope) / squares / samples});
    }
    return shares;
}

}  // namespace

double law_variance(const TerrainModel& terrain) {
    double sum = 0.0;
    each_wave(terrain, [&](int, int, double energy) { sum += 2.0 * energy; });
    return sum;
}

double seed_variance(const TerrainModel& terrain, ThreadPool& pool) {
    const double dk = kTwoPi / terrain.patch_size;
    return dk * dk * TerrainNoise(terrain, pool).energy(amplitudes_of(terrain), pool);
}

std::vector<std::uint32_t> seeds_of_variance(const TerrainModel& terrain, double variance,
                                             int count, ThreadPool& pool) {
    TerrainModel longest = terrain;
    longest.resolution = std::min(terrain.resolution, kLongWaves);
    // The shorter waves are so many that every seed has their mean.
    const double shorter = law_variance(terrain) - law_variance(longest);
    std::vector<std::pair<double, std::uint32_t>> seeds;
    for (longest.seed = 1; longest.seed <= kSeedsTried; ++longest.seed) {
        const double found = seed_variance(longest, pool) + shorter;
        seeds.emplace_back(std::abs(std::log(found / variance)), longest.seed);
    }
    std::ranges::sort(seeds);
    std::vector<std::uint32_t> closest;
    for (int i = 0; i < count; ++i) closest.push_back(seeds[static_cast<std::size_t>(i)].second);
    return closest;
}

double expected_tilt(const TerrainModel& terrain, const std::array<int, 2>& samples) {
    const int half = terrain.resolution / 2;
    const double phase_step = kTwoPi / terrain.resolution;
    const std::vector<LineShares> x = line_shares(samples[0], phase_step, half);
    const std::vector<LineShares> y = line_shares(samples[1], phase_step, half);
    double plane = 0.0, rest = 0.0;
    each_wave(terrain, [&](int n, int m, double energy) {
        const LineShares& along = x[static_cast<std::size_t>(n)];
        const LineShares& across = y[static_cast<std::size_t>(std::abs(m))];
        const double mean = along.mean * across.mean;
        const double slope = along.slope * across.mean + along.mean * across.slope;
        plane += energy * slope;
        rest += energy * (1.0 - mean - slope);
    });
    return plane / rest;
}

}  // namespace ocean
