// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The division of the modes: the pairs' signals and the remainder together are the open sea.

#include "divided_sea.hpp"
#include "ocean/internal/wave_sum.hpp"

namespace ocean {
namespace {

using test::DividedSea;
using test::Places;

// Each mode is in one pair, with 2 h0, or in the remainder, with h0, and in no other.
TEST(OpenRemainder, AndThePairsDivideTheModes) {
    Parameters parameters = test::wind_sea(128, 400.0, {.cascades = 2});
    const DividedSea sea(parameters);
    const Modes remainder = open_remainder(sea.modes, sea.bands);
    std::map<std::array<int, 2>, std::complex<float>> held;
    std::size_t count = 0;
    for (const BandLattice& band : gather_bands(sea.modes, sea.bands)) {
        const int divisor = static_cast<int>(std::round(400.0 / band.period));
        count += band.modes.size();
        for (const BandMode& mode : band.modes) {
            EXPECT_LE(std::abs(mode.n), band.reach[0]);
            EXPECT_LE(std::abs(mode.m), band.reach[1]);
            held[{(mode.n + band.carrier[0]) * divisor, (mode.m + band.carrier[1]) * divisor}] +=
                mode.amplitude;
        }
    }
    EXPECT_EQ(held.size(), count);
    std::size_t found = 0;
    for (std::size_t c = 0; c < sea.modes.cascades.size(); ++c) {
        const CascadeModes& cascade = sea.modes.cascades[c];
        const int size = cascade.lattice.resolution;
        for (const auto [n, m] : test::pairs({-size / 2, size / 2}, {-size / 2, size / 2})) {
            const std::size_t at = mode_index(n, m, size);
            if (cascade.h0[at] == 0.0f) continue;
            const auto pair = held.find({n * cascade.divisor, m * cascade.divisor});
            const bool in_pair = pair != held.end();
            found += in_pair;
            ASSERT_EQ(remainder.cascades[c].h0[at], in_pair ? 0.0f : cascade.h0[at]);
            if (!in_pair) continue;
            ASSERT_EQ(pair->second, 2.0f * cascade.h0[at]);
        }
    }
    EXPECT_EQ(found, count);
    EXPECT_GT(count, 1000u);
    EXPECT_FALSE(remainder.revision == sea.modes.revision);
    EXPECT_EQ(remainder.lattice_revision == sea.modes.lattice_revision,
              static_cast<bool>(sea.modes.lattice_revision));
}

// In double, mode by mode, they are the open sea to rounding, with or without cascades and loops.
TEST(OpenRemainder, AndExactSumsOfPairsAreTheOpenSea) {
    for (const int cascades : {1, 2}) {
        for (const double loop : {0.0, 60.0}) {
            Parameters parameters = test::wind_sea(64, 300.0, {.loop = loop, .cascades = cascades});
            const DividedSea sea(parameters);
            const BandSignals signals(sea.modes, sea.bands);
            WaveSum open(sea.modes, parameters.water);
            WaveSum rest(open_remainder(sea.modes, sea.bands), parameters.water);
            for (const double time : {3.5, 1e6}) {
                open.set_time(time);
                rest.set_time(time);
                const Places at(5, -500.0, 500.0);
                for (std::size_t i = 0; i < at.size(); ++i) {
                    const LinearSample expected = open.at_label(at.x[i], at.y[i]);
                    LinearSample sum = rest.at_label(at.x[i], at.y[i]);
                    for (std::size_t pair = 0; pair < signals.count(); ++pair) {
                        const ExactSignal part = signals.exact(pair, time, at.x[i], at.y[i]);
                        sum.height += part.value.real();
                        sum.slope_x += part.by_x.real();
                        sum.slope_y += part.by_y.real();
                        sum.height_rate += part.rate.real();
                    }
                    EXPECT_NEAR(sum.height, expected.height, 1e-9 * sea.height);
                    EXPECT_NEAR(sum.slope_x, expected.slope_x, 1e-9);
                    EXPECT_NEAR(sum.slope_y, expected.slope_y, 1e-9);
                    EXPECT_NEAR(sum.height_rate, expected.height_rate, 1e-8);
                }
            }
        }
    }
}

// Only what remains can make whitecaps: its covariance of gradients is that of its modes.
TEST(OpenRemainder, HasTheGradientsOfItsModes) {
    const DividedSea sea(test::wind_sea(256, 400.0));
    const GradientCovariance whole = sea.modes.gradient_covariance(256);
    const Modes rest = open_remainder(sea.modes, sea.bands);
    double all = 0.0, remaining = 0.0;
    const CascadeModes& cascade = sea.modes.cascades.front();
    const double step = cascade.lattice.wavenumber_step();
    for (const auto [n, m] : test::pairs({-127, 128}, {-127, 128})) {
        const std::size_t at = mode_index(n, m, 256);
        const double k2 = step * step * (n * n + m * m);
        const double factor = std::pow(k2 * static_cast<double>(cascade.displacement[at]), 2);
        all += factor * std::norm(std::complex<double>(cascade.h0[at]));
        remaining += factor * std::norm(std::complex<double>(rest.cascades[0].h0[at]));
    }
    const GradientCovariance left = rest.gradient_covariance(256);
    EXPECT_NEAR((left.aa + left.bb) / (whole.aa + whole.bb), remaining / all, 0.02);
    EXPECT_GT(remaining, 0.0);
    EXPECT_LT(remaining, 0.9 * all);
}

}  // namespace
}  // namespace ocean
