// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Beds by functions of the place, for the tests of a coast.
#pragma once

#include "coast/bed/bed_grid.hpp"
#include "ocean/parameters.hpp"
#include "ocean/sea_bed.hpp"
#include "testing.hpp"

namespace ocean::test {

/// Returns height(x, y) [m] on samples `cell` apart from (0, 0) on.
template <typename Height>
BedGrid grid_of(int columns, int rows, double cell, const Height& height) {
    BedGrid grid;
    grid.domain = {{0.0, 0.0}, {cell * (columns - 1), cell * (rows - 1)}, {columns, rows}, false};
    for (const auto [i, j] : pairs(columns, rows)) {
        grid.values.push_back(static_cast<float>(height(i * cell, j * cell)));
    }
    return grid;
}

/// Returns such a bed as a file gives it.
template <typename Height>
GivenBed bed_of(int columns, int rows, double cell, const Height& height) {
    const BedGrid grid = grid_of(columns, rows, cell, height);
    GivenBed given;
    given.grid = grid.domain;
    given.heights.assign(grid.values.begin(), grid.values.end());
    return given;
}

/// Lays a bed below a sea, in place of the one that it has.
inline Parameters over(Parameters parameters, GivenBed given) {
    parameters.water.bed = nullptr;
    parameters.water.bed = make_sea_bed(std::move(given), parameters.water);
    return parameters;
}

/// JONSWAP of a wind of 12 m/s over 150 km, to the east: Hs 2.9 m, Tp 7.4 s.
inline Parameters coast_sea(int resolution, double patch, double depth) {
    Parameters parameters;
    parameters.grid.resolution = resolution;
    parameters.grid.patch_size = patch;
    parameters.water.depth = depth;
    WaveSystem& waves = parameters.waves.front();
    waves.spectrum = SpectrumKind::jonswap;
    waves.wind_speed = 12.0;
    waves.fetch = 150000.0;
    return parameters;
}

}  // namespace ocean::test
