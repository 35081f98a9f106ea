// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The promise of calibrated metres: realised seas have the energy that the spectrum has, whatever
// the grid, and they are neither mirrored nor standing.

#include "ocean/internal/spectrum.hpp"
#include "test_seas.hpp"

namespace ocean {
namespace {

TEST(Statistics, MeanVarianceOver64SeedsIsTheSumOverTheModes) {
    Parameters parameters = test::wind_sea(128, 400.0);
    const double expected = test::state_of(parameters).significant_wave_height.resolved;
    test::SampleMean variance;
    for (parameters.seed = 1; parameters.seed <= 64; ++parameters.seed) {
        Ocean sea(parameters, {.threads = 2});
        variance.add(test::variance(test::values_of(sea.evaluate(0.0, {Channel::height}))));
    }
    EXPECT_NEAR(variance.mean(), expected * expected / 16.0, 3.0 * variance.error());
    EXPECT_LT(variance.error() / variance.mean(), 0.03) << "the test would see nothing";
}

TEST(Statistics, TheSumOverModesIsTheIntegralOverTheResolvedBandForEveryGrid) {
    for (const double patch : {400.0, 800.0, 1600.0}) {
        for (const int resolution : {256, 512}) {
            const Parameters parameters = test::wind_sea(resolution, patch);
            const DirectionalSpectrum spectrum = make_directional_spectrum(parameters);
            const SeaState state = sea_state(spectrum, parameters, test::pool());
            if (state.energy_resolved < 0.99) continue;
            // The band is a square in k; its corners beyond the inscribed circle hold little.
            const double nyquist = patch / (resolution / 2 - 0.5);
            const double circle = spectrum.moments(parameters.water, nyquist).m0;
            const double corner = spectrum.moments(parameters.water, nyquist / std::sqrt(2.0)).m0;
            const double m0 = std::pow(state.significant_wave_height.resolved / 4.0, 2.0);
            EXPECT_GT(m0, circle * 0.997) << patch << " " << resolution;
            EXPECT_LT(m0, corner * 1.003) << patch << " " << resolution;
        }
    }
}

TEST(Statistics, ASwellNarrowerThanTheLatticeKeepsItsEnergyOnEveryPatch) {
    Parameters parameters = test::wind_sea(256);
    WaveSystem& system = parameters.waves.front();
    system.peak_enhancement = 10.0;
    system.peak_period = 13.0;  // 264 m
    system.swell = 1.0;
    const DirectionalSpectrum spectrum = make_directional_spectrum(parameters);
    for (double patch = 800.0; patch < 1300.0; patch += 61.0) {
        parameters.grid.patch_size = patch;
        const SeaState state = sea_state(spectrum, parameters, test::pool());
        EXPECT_NEAR(state.significant_wave_height.resolved / state.significant_wave_height.asked,
                    1.0, 3e-3)
            << patch;
    }
}

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

TEST(Statistics, TheSeaIsNotAMirrorImageOfItself) {
    Parameters parameters = test::wind_sea(128, 400.0);
    parameters.waves.front().spectrum = SpectrumKind::phillips;  // as much with as against the wind
    Ocean sea(parameters, {.threads = 1});
    for (const double time : {1.0, 1.7, 5.0}) {
        const Surface surface = sea.evaluate(time, {Channel::height});
        const auto h = surface.channel(Channel::height);
        double sum = 0.0;
        for (const auto [i, j, at] : test::cells<std::size_t>(128, 128)) {
            sum += h[at] * h[(128 - j) % 128 * 128 + (128 - i) % 128];
        }
        EXPECT_LT(std::abs(sum / (128.0 * 128.0) / test::variance(h)), 0.15) << time;
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
