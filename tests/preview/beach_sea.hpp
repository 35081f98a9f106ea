// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A sea over a small beach.
#pragma once

#include <algorithm>
#include <array>

#include "ocean/sea.hpp"
#include "ocean/sea_bed.hpp"

namespace ocean::test {

/// Returns a beach from its south-west corner [m] on, that rises 1:20 to the east, from 8 m of
/// water to 4 m of land, under waves of 9 m/s.
inline Sea beach_sea(std::array<double, 2> corner = {}) {
    Parameters parameters;
    parameters.grid.resolution = 64;
    parameters.grid.patch_size = 128.0;
    parameters.water.depth = 8.0;
    WaveSystem& waves = parameters.waves.front();
    waves.spectrum = SpectrumKind::jonswap;
    waves.wind_speed = 9.0;
    waves.wind_direction = 0.0;
    waves.fetch = 20000.0;
    parameters.water.seabed_origin = {corner[0], corner[1]};
    GivenBed given;
    given.grid = {{0.0, 0.0}, {320.0, 192.0}, {81, 49}, false};
    for (int j = 0; j < 49; ++j) {
        for (int i = 0; i < 81; ++i) {
            given.heights.push_back(static_cast<float>(std::max(-8.0, (4.0 * i - 240.0) / 20.0)));
        }
    }
    parameters.water.bed = make_sea_bed(std::move(given), parameters.water);
    return {parameters, {}};
}

}  // namespace ocean::test
