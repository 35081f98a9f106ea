// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Foam on maps that are finer than its lattice: as much of it as the wind makes, the lattice's
// ticks alone to pay for, and the same bits however a frame is reached.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "test_seas.hpp"

namespace ocean {
namespace {

/// A sea of two cascades, whose map has four times the samples of its grid along each side.
Parameters two_cascades(int resolution, double patch, double wind) {
    Parameters parameters = test::wind_sea(resolution, patch);
    parameters.grid.cascades = 2;
    parameters.surface.foam_resolution = resolution;
    parameters.waves.front().wind_speed = wind;
    parameters.waves.front().fetch = 30000.0;
    return parameters;
}

TEST(FoamLattice, IsTheMapsUnlessACoarserOneIsSet) {
    Parameters parameters = two_cascades(64, 100.0, 14.0);
    EXPECT_EQ(foam_lattice(parameters, 256), (FoamLattice{64, 32}));
    EXPECT_EQ(foam_lattice(parameters, 64), (FoamLattice{64, 64}));
    EXPECT_EQ(foam_lattice(parameters, 32), (FoamLattice{32, 32}));
    parameters.surface.foam_resolution = 0;
    EXPECT_EQ(foam_lattice(parameters, 256), (FoamLattice{256, 256}));
}

TEST(FoamLattice, SpreadingKeepsItsSamplesAndItsCover) {
    constexpr int kLattice = 32, kMap = 128;
    constexpr double kPower = 3.2;
    std::vector<float> lattice(kLattice * kLattice);
    for (std::size_t i = 0; i < lattice.size(); ++i) {
        lattice[i] = i % 3 == 0 ? 0.0f : static_cast<float>(i % 17) / 17.0f;
    }
    ThreadPool pool(2);
    std::vector<float> map(kMap * kMap);
    spread_foam(lattice, kPower, map, pool);
    const auto cover = [](std::span<const float> foam) {
        double sum = 0.0;
        for (const float value : foam) sum += std::pow(static_cast<double>(value), kPower);
        return sum / static_cast<double>(foam.size());
    };
    EXPECT_NEAR(cover(map) / cover(lattice), 1.0, 1e-6);
    for (std::size_t j = 0; j < kLattice; ++j) {
        for (std::size_t i = 0; i < kLattice; ++i) {
            ASSERT_NEAR(map[4 * j * kMap + 4 * i], lattice[j * kLattice + i], 1e-6f);
        }
    }
    // Beyond the last column and row the first begin again.
    const double seam =
        0.5 * (std::pow(lattice[kLattice - 1], kPower) + std::pow(lattice[0], kPower));
    EXPECT_NEAR(std::pow(map[kMap - 2], kPower), seam, 1e-6);
}

TEST(FoamLattice, FinerMapsPayForTheTicksOfTheLatticeAlone) {
    const Parameters parameters = two_cascades(64, 100.0, 14.0);
    Ocean sea(parameters, {.threads = 2});
    sea.evaluate(3.0, {Channel::foam}, 256);
    const int ticks = sea.stage_runs().foam_ticks;
    EXPECT_GT(ticks, 400);
    sea.evaluate(3.0, {Channel::foam}, 128);
    EXPECT_EQ(sea.stage_runs().foam_ticks, ticks) << "finer maps share their past";
}

TEST(FoamLattice, AFrameHasTheSameBitsAloneAndInSequence) {
    Parameters parameters = two_cascades(32, 160.0, 14.0);
    const ChannelSet channels = {Channel::foam, Channel::cover, Channel::whitecap};
    const auto frame = [&](Ocean& sea, int number) {
        return sea.evaluate(sea.sea().time_of(number), channels);
    };
    Ocean alone(parameters, {.threads = 1});
    const Surface expected = frame(alone, 200);
    ASSERT_GT(expected.resolution(), parameters.grid.resolution);
    EXPECT_GT(test::variance(expected.channel(Channel::foam)), 1e-4) << "there is foam to compare";
    Ocean sequence(parameters, {.threads = 2});
    for (int number = 190; number < 200; ++number) frame(sequence, number);
    const Surface reached = frame(sequence, 200);
    for (const Channel channel : {Channel::foam, Channel::cover}) {
        EXPECT_TRUE(std::ranges::equal(reached.channel(channel), expected.channel(channel)));
    }
    for (std::size_t i = 0; i < expected.channel(Channel::foam).size(); ++i) {
        ASSERT_GE(expected.channel(Channel::foam)[i], expected.channel(Channel::whitecap)[i]);
    }
}

TEST(FoamLattice, APastOfAllWavesOfTheMapHasThePowerOfTheMap) {
    Parameters parameters = two_cascades(64, 100.0, 14.0);
    const double layered = [&] {
        // No wave of the map is shorter than four samples of the lattice.
        Parameters calm = parameters;
        calm.surface.shortest_wavelength = 4.2 * 100.0 / 64.0;
        return Ocean(calm, {.threads = 2}).cover_power(0.0, 256);
    }();
    parameters.surface.shortest_wavelength = 4.2 * 100.0 / 64.0;
    parameters.surface.foam_resolution = 0;
    EXPECT_NEAR(layered, Ocean(parameters, {.threads = 2}).cover_power(0.0, 256), 0.01 * layered);
}

struct Weather {
    double wind;  // m/s
    int seas;     // rare whitecaps need more of them
};
void PrintTo(const Weather& weather, std::ostream* out) {
    *out << weather.wind << " m/s";
}

class FoamLatticeCoverOf : public testing::TestWithParam<Weather> {};

TEST_P(FoamLatticeCoverOf, TheMeanCoverOfAFinerMapIsThatOfItsWhitecaps) {
    double cover = 0.0, whitecap = 0.0, closed_form = 0.0;
    Parameters parameters = two_cascades(128, 200.0, GetParam().wind);
    for (int seed = 1; seed <= GetParam().seas; ++seed) {
        parameters.seed = static_cast<std::uint32_t>(seed);
        Ocean sea(parameters, {.threads = 2});
        for (int i = 0; i < 12; ++i) {
            const Surface now = sea.evaluate(2.5 * i, {Channel::cover, Channel::whitecap});
            ASSERT_EQ(now.resolution(), 512);
            cover += test::mean(now.channel(Channel::cover));
            whitecap += test::mean(now.channel(Channel::whitecap));
            closed_form += monahan_coverage(GetParam().wind);
        }
    }
    EXPECT_NEAR(cover / whitecap, 1.0, 0.025);
    EXPECT_NEAR(whitecap / closed_form, 1.0, 0.05);
}

INSTANTIATE_TEST_SUITE_P(Each, FoamLatticeCoverOf,
                         testing::Values(Weather{12.3, 8}, Weather{18.9, 6}, Weather{22.6, 6}));

}  // namespace
}  // namespace ocean
