// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Modes: the lattice, the draw, the band, the clock.
#include "ocean/internal/modes.hpp"

#include "ocean/internal/dispersion.hpp"
#include "ocean/thread_pool.hpp"
#include "test_seas.hpp"

namespace ocean {
namespace {

TEST(Grid, WavenumbersAreThoseOfFftfreq) {
    const int expected[] = {0, 1, 2, 3, -4, -3, -2, -1};
    for (int i = 0; i < 8; ++i) {
        EXPECT_EQ(signed_wavenumber(i, 8), expected[i]);
        EXPECT_EQ(fft_index(expected[i], 8), i);
    }
}

TEST(Modes, AFinerGridKeepsTheBitsOfSharedModes) {
    const Modes coarse = test::modes_of(test::wind_sea(64));
    const Modes fine = test::modes_of(test::wind_sea(256));
    int compared = 0;
    for (const auto [n, m] : test::pairs({-31, 32}, {-31, 32})) {
        const auto& a = coarse.cascades[0].h0[mode_index(n, m, 64)];
        const auto& b = fine.cascades[0].h0[mode_index(n, m, 256)];
        ASSERT_EQ(std::memcmp(&a, &b, sizeof(a)), 0) << n << " " << m;
        compared += a != std::complex<float>(0.0f) ? 1 : 0;
    }
    EXPECT_GT(compared, 3000);
}

TEST(Modes, HeightsOfTwoSeasCorrelateAsTheirMapsDo) {
    const auto correlation_of_maps = [](Ocean& a, double time_a, Ocean& b, double time_b) {
        const auto x = test::values_of(a.evaluate(time_a, {Channel::height}));
        const auto y = test::values_of(b.evaluate(time_b, {Channel::height}));
        double xy = 0.0;
        for (std::size_t i = 0; i < x.size(); ++i) xy += double{x[i]} * double{y[i]};
        return xy / static_cast<double>(x.size()) / test::rms(x) / test::rms(y);
    };
    Parameters parameters = test::wind_sea(64);
    Parameters stronger = parameters, deeper = parameters, other = parameters, larger = parameters;
    stronger.waves.front().wind_speed = 18.0;
    deeper.water.depth = 3.0;
    other.seed = 77;
    larger.grid.patch_size *= 1.1;
    Ocean sea(parameters);
    EXPECT_NEAR(height_correlation(sea.modes(), 3.0, sea.modes(), 3.0), 1.0, 1e-6);
    for (const auto& [changed, allowed] : {std::pair(stronger, 0.1), {deeper, 0.1}, {other, 0.1}}) {
        for (const double time : {0.0, 3.0, 1000.0}) {
            Ocean second(changed);
            const double found = height_correlation(sea.modes(), time, second.modes(), time);
            EXPECT_NEAR(found, correlation_of_maps(sea, time, second, time), allowed) << time;
        }
    }
    Ocean second(stronger);
    EXPECT_GT(height_correlation(sea.modes(), 5.0, second.modes(), 5.0), 0.8);
    EXPECT_LT(std::abs(height_correlation(sea.modes(), 5.0, second.modes(), 500.0)), 0.2);
    EXPECT_EQ(height_correlation(sea.modes(), 0.0, Ocean(larger).modes(), 0.0), 0.0);
    Parameters calm = parameters;
    calm.waves.front().wind_speed = 0.0;
    EXPECT_EQ(height_correlation(sea.modes(), 0.0, Ocean(calm).modes(), 0.0), 0.0);
}

TEST(Modes, ModalVarianceIsTheEnergyOfTheModesCellInWavenumberSpace) {
    const Parameters parameters = test::wind_sea();
    const DirectionalSpectrum spectrum = make_directional_spectrum(parameters);
    const double step = kTwoPi / 400.0;
    const auto energy = [&](double n, double m) {
        const double k = step * std::hypot(n, m);
        const double omega = std::sqrt(9.81 * k + 7.4e-5 * k * k * k);
        const double group_velocity = (9.81 + 3.0 * 7.4e-5 * k * k) / (2.0 * omega);
        return spectrum.density(omega, std::atan2(m, n)) * group_velocity / k * step * step;
    };
    // Far out the cell is small: its centre is its mean.
    EXPECT_NEAR(modal_variance(spectrum, parameters, 90, 120) / energy(90, 120), 1.0, 1e-12);
    // Near the peak it is not.
    double mean = 0.0;
    constexpr int kFine = 200;
    for (const auto [a, b] : test::pairs(kFine, kFine)) {
        mean += energy(5.5 + (a + 0.5) / kFine, 2.5 + (b + 0.5) / kFine) / (kFine * kFine);
    }
    EXPECT_NEAR(modal_variance(spectrum, parameters, 6, 3) / mean, 1.0, 1e-3);
    EXPECT_GT(std::abs(energy(6, 3) / mean - 1.0), 0.01) << "the centre would do as well";
}

TEST(Modes, BandLimitsKeepWavesOfExactlyThatLength) {
    Parameters parameters = test::wind_sea();
    const DirectionalSpectrum spectrum = make_directional_spectrum(parameters);
    parameters.surface.shortest_wavelength = 400.0 / 8.0;
    parameters.surface.longest_wavelength = 400.0 / 5.0;
    EXPECT_GT(modal_variance(spectrum, parameters, 8, 0), 0.0);
    EXPECT_EQ(modal_variance(spectrum, parameters, 8, 1), 0.0);
    EXPECT_EQ(modal_variance(spectrum, parameters, 9, 0), 0.0);
    EXPECT_GT(modal_variance(spectrum, parameters, 3, 4), 0.0);
    EXPECT_EQ(modal_variance(spectrum, parameters, 4, 0), 0.0);
}

TEST(Modes, PhaseRateIsTheDispersionRelationForNegativeWavenumbersToo) {
    for (const double depth : {5.0, std::numeric_limits<double>::infinity()}) {
        Parameters parameters = test::wind_sea(64, 400.0, {.depth = depth});
        const Modes modes = test::modes_of(parameters);
        const Dispersion dispersion(parameters.water);
        const CascadeModes& cascade = modes.cascades[0];
        for (const auto [n, m] : test::pairs({-31, 32}, {-31, 32})) {
            if (n == 0 && m == 0) continue;
            const double k = kTwoPi / 400.0 * std::hypot(n, m);
            const double rate = static_cast<double>(cascade.rate_high[mode_index(n, m, 64)]) +
                                cascade.rate_low[mode_index(n, m, 64)];
            EXPECT_NEAR(rate * kTwoPi / dispersion.angular_frequency(k), 1.0, 1e-13);
        }
    }
}

TEST(Loop, RatesAreRoundedToWholeTurnsAndNeverToZero) {
    EXPECT_EQ(turns_per_loop(kTwoPi * 0.1, 26.0), 3.0);  // 2.6 turns: floor would say 2
    EXPECT_EQ(turns_per_loop(kTwoPi * 0.1, 24.0), 2.0);
    EXPECT_EQ(turns_per_loop(kTwoPi * 0.001, 10.0), 1.0);
    Parameters parameters = test::wind_sea(64, 400.0, {.loop = 10.0});
    const Modes modes = test::modes_of(parameters);
    for (const auto [n, m] : test::pairs({-31, 32}, {-31, 32})) {
        if (n == 0 && m == 0) continue;
        const float rate = modes.cascades[0].rate_high[mode_index(n, m, 64)];
        EXPECT_GE(rate, 1.0f);
        EXPECT_EQ(rate, std::round(rate));
        EXPECT_EQ(modes.cascades[0].rate_low[mode_index(n, m, 64)], 0.0f);
    }
}

}  // namespace
}  // namespace ocean
