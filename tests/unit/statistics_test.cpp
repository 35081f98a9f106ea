// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The promise of calibrated metres: realised seas have the energy that the spectrum has, whatever
// the grid, and they are neither mirrored nor standing.

#include "ocean/internal/spectrum.hpp"
#include "test_seas.hpp"

namespace ocean {
namespace {

TEST(Statistics, EveryRecordKeepsItsEnergyOnEveryPatch) {
    // Swells of one frequency bin and of the narrowest beam that two moments allow.
    for (const double frequency : {0.07, 0.13}) {
        auto record = std::make_shared<SpectrumRecord>();
        for (int i = 0; i < 5; ++i) {
            record->frequency.push_back(frequency + 0.005 * (i - 2));
            record->density.push_back(i == 2 ? 1.0 : 0.05);
            record->a1.push_back(0.97 * std::cos(1.1));
            record->b1.push_back(0.97 * std::sin(1.1));
            record->a2.push_back(0.93 * std::cos(2.2));
            record->b2.push_back(0.93 * std::sin(2.2));
        }
        Parameters parameters;
        parameters.waves.front().spectrum = SpectrumKind::measured;
        parameters.waves.front().measured = record;
        const DirectionalSpectrum spectrum = make_directional_spectrum(parameters);
        for (double patch = 600.0; patch < 1100.0; patch += 97.0) {
            parameters.grid.patch_size = patch;
            const SeaState state = sea_state(spectrum, parameters, test::pool());
            EXPECT_NEAR(std::pow(state.significant_wave_height.resolved /
                                     state.significant_wave_height.asked,
                                 2.0),
                        1.0, 3e-3)
                << frequency << " Hz, " << patch << " m";
            // It travels as the two or three modes that hold it do.
            EXPECT_NEAR(state.mean_direction.resolved, state.mean_direction.asked, 3.0);
        }
    }
}

TEST(Statistics, MeanSquareSlopeOfTheMapIsThatOfTheModes) {
    const Parameters parameters = test::wind_sea(256, 400.0);
    const double expected = test::state_of(parameters).mean_square_slope.resolved;
    Ocean sea(parameters, {.threads = 2});
    const Surface surface = sea.evaluate(4.0, {Channel::slope_x, Channel::slope_y});
    EXPECT_NEAR((test::variance(surface.channel(Channel::slope_x)) +
                 test::variance(surface.channel(Channel::slope_y))) /
                    expected,
                1.0, 0.05);
}

}  // namespace
}  // namespace ocean
