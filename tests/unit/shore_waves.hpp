// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Beds and seas for the tests of a coast.
#pragma once

#include "coast/bed/bed_grid.hpp"
#include "coast/statics/eikonal.hpp"
#include "coast/statics/shore_bands.hpp"
#include "coast/statics/shore_delays.hpp"
#include "coast/statics/slowness.hpp"
#include "ocean/internal/dispersion.hpp"
#include "test_beds.hpp"

namespace ocean {

inline constexpr double kGravity = 9.81;

inline SampleGrid size_of(const BedGrid& grid) {
    return {grid.domain.samples[0], grid.domain.samples[1]};
}

/// The bands that the wind sea below has: equal ratios of wavenumbers of 0.45 to 4 rad/s.
inline ShoreBands bands_of_wind_sea(const std::vector<int>& sectors) {
    ShoreBands bands;
    const double low = 0.45 * 0.45 / kGravity, high = 16.0 / kGravity;
    for (int b = 0; b <= kShoreBands; ++b) {
        bands.edges[static_cast<std::size_t>(b)] =
            low * std::pow(high / low, static_cast<double>(b) / kShoreBands);
    }
    for (const int sector : sectors) {
        for (int b = 0; b < kShoreBands; ++b) bands.waves.push_back({b, sector, 1.0});
    }
    return bands;
}

/// JONSWAP for a wind of 12 m/s over 150 km, not scaled.
inline double wind_sea(double omega) {
    const double fetch = kGravity * 1.5e5 / 144.0;
    const double peak = kTwoPi * 3.5 * (kGravity / 12.0) * std::pow(fetch, -0.33);
    const double width = omega <= peak ? 0.07 : 0.09;
    const double r = (omega - peak) / (width * peak);
    return std::pow(omega, -5.0) * std::exp(-1.25 * std::pow(peak / omega, 4)) *
           std::pow(3.3, std::exp(-0.5 * r * r));
}

inline Water water_of_depth(double depth) {
    Water water;
    water.depth = depth;
    water.surface_tension = 0.0;
    return water;
}

using test::grid_of;

inline double wavenumber(double omega, double depth) {
    return Dispersion(water_of_depth(depth)).wavenumber(omega);
}

/// One wave over a bed: its slowness and delays by the solver alone.
struct OneWave {
    SampleGrid grid;
    std::vector<float> slowness;
    PlaneVector direction;
    std::vector<double> delay;  // [cells]
    int sweeps = 0;

    OneWave(const BedGrid& depth, double k, double angle,
            int max_sweeps = EikonalSolver::kMaxSweeps,
            const Water& water = water_of_depth(std::numeric_limits<double>::infinity()))
        : grid(size_of(depth)), direction{std::cos(angle), std::sin(angle)} {
        const Slowness table(k, water,
                             double{*std::min_element(depth.values.begin(), depth.values.end())});
        for (const float d : depth.values) slowness.push_back(table.at(double{d}));
        const BorderSlopes border(depth);
        EikonalSolver solver(grid, border);
        sweeps = solver.solve(slowness, direction, max_sweeps);
        for (const auto [i, j] : test::pairs(grid.columns, grid.rows)) {
            delay.push_back(solver.delay(i, j));
        }
    }
    /// Smooths by 1-2-1 four times along each axis, which is what the maps have.
    void smooth() {
        for (int n = 0; n < 8; ++n) {
            const int di = n % 2, dj = 1 - di;
            const std::vector<double> old = delay;
            for (const auto [i, j] : test::pairs({1, grid.columns - 1}, {1, grid.rows - 1})) {
                delay[grid.index(i, j)] =
                    0.5 * old[grid.index(i, j)] +
                    0.25 * (old[grid.index(i - di, j - dj)] + old[grid.index(i + di, j + dj)]);
            }
        }
    }
    /// Returns the wave vector over that of the open sea.
    PlaneVector wave(int i, int j) const {
        return {direction.x + 0.5 * (delay[grid.index(i + 1, j)] - delay[grid.index(i - 1, j)]),
                direction.y + 0.5 * (delay[grid.index(i, j + 1)] - delay[grid.index(i, j - 1)])};
    }
};

/// Returns the gradient of a map [1/m of its unit].
inline PlaneVector gradient_of(const std::vector<float>& map, const SampleGrid& grid, double cell,
                               int i, int j) {
    const auto value = [&](int x, int y) { return double{map[grid.index(x, y)]}; };
    return {(value(i + 1, j) - value(i - 1, j)) / (2.0 * cell),
            (value(i, j + 1) - value(i, j - 1)) / (2.0 * cell)};
}

/// Returns the wave vector that maps give a wave k of the open sea [rad/m].
inline PlaneVector mapped_wave(const DelayMaps& maps, const SampleGrid& grid, double cell, int i,
                               int j, PlaneVector k) {
    const PlaneVector x = gradient_of(maps.shift_x, grid, cell, i, j);
    const PlaneVector y = gradient_of(maps.shift_y, grid, cell, i, j);
    const PlaneVector p = gradient_of(maps.phase, grid, cell, i, j);
    return {k.x + k.x * x.x + k.y * y.x + p.x, k.y + k.x * x.y + k.y * y.y + p.y};
}

inline BedGrid islands() {
    // Three islands whose shelves throw lees that cross each other.
    return grid_of(220, 200, 4.0, [](double x, double y) {
        double depth = 40.0;
        for (const auto& [px, py, r] :
             {std::array{250.0, 300.0, 60.0}, {420.0, 450.0, 40.0}, {380.0, 250.0, 25.0}}) {
            depth = std::min(depth, 0.06 * std::max(std::hypot(x - px, y - py) - r, 0.0));
        }
        return std::max(depth, 0.6);
    });
}

/// A bed of random bumps of many sizes on a slope: as felt, its rms slope is 1:11, that of a reef.
inline BedGrid rough_bed(int columns, int rows, double cell) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> phase(0.0, kTwoPi);
    struct Bump {
        double kx, ky, p, a;
    };
    std::vector<Bump> bumps;
    for (double length = 400.0; length > 12.0; length /= 1.15) {
        for (int n = 0; n < 3; ++n) {
            const double angle = phase(random);
            bumps.push_back({kTwoPi / length * std::cos(angle), kTwoPi / length * std::sin(angle),
                             phase(random), 0.3 * length / 100.0});
        }
    }
    return grid_of(columns, rows, cell, [&](double x, double y) {
        double z = -18.0 + x / 40.0;
        for (const Bump& b : bumps) z += b.a * std::cos(b.kx * x + b.ky * y + b.p);
        return z;
    });
}

}  // namespace ocean
