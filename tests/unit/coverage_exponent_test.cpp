// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// How much of the water foam covers: its mean against that of the whitecaps, in whole seas.

#include "ocean/internal/foam.hpp"
#include "ocean/internal/map_levels.hpp"
#include "ocean/thread_pool.hpp"
#include "test_seas.hpp"

namespace ocean {
namespace {

Parameters sea_of(double wind) {
    return test::wind_sea(128, 20.0 * wind, {.wind = wind, .fetch = 30000.0});
}

double power_of(const Parameters& parameters, int threads) {
    Ocean sea(parameters, {.threads = threads});
    return sea.cover_power(0.0, parameters.grid.resolution);
}

double mean_of(const Surface& surface, Channel channel) {
    return test::mean(surface.channel(channel));
}

/// A wind [m/s] and a number of seas: rare whitecaps need more of them.
using Weather = std::pair<double, int>;

class FoamCoverOf : public testing::TestWithParam<Weather> {};

TEST_P(FoamCoverOf, ItsMeanIsThatOfTheWhitecaps) {
    const auto [wind, seas] = GetParam();
    double cover = 0.0, whitecap = 0.0;
    Parameters parameters = sea_of(wind);
    for (int seed = 1; seed <= seas; ++seed) {
        parameters.seed = static_cast<std::uint32_t>(seed);
        Ocean sea(parameters, {.threads = 2});
        for (int i = 0; i < 60; ++i) {
            const Surface now = sea.evaluate(0.5 * i, {Channel::cover, Channel::whitecap});
            cover += mean_of(now, Channel::cover);
            whitecap += mean_of(now, Channel::whitecap);
        }
        EXPECT_EQ(sea.stage_runs().cover_power, 1);
    }
    EXPECT_NEAR(cover / whitecap, 1.0, 0.02);
}

// Beaufort 4, 6, 8, 9 and 10. Of these, Foam.TheMeanWhitecapIsThatOfRandomGradients says that their
// mean is Monahan's.
INSTANTIATE_TEST_SUITE_P(Each, FoamCoverOf,
                         testing::Values(Weather{6.7, 24}, Weather{12.3, 12}, Weather{18.9, 8},
                                         Weather{22.6, 8}, Weather{26.4, 8}));

TEST(FoamCover, ThePowerDependsOnNoThreadsAndNoSeed) {
    Parameters parameters = sea_of(12.3);
    const double power = power_of(parameters, 1);
    EXPECT_EQ(power_of(parameters, 3), power);
    parameters.seed = 77;
    EXPECT_NEAR(power_of(parameters, 2), power, 1e-3);
}

TEST(FoamCover, ThePowerHasNoJumpsWhereTheWindRises) {
    double before = power_of(sea_of(12.0), 2);
    for (int i = 1; i <= 10; ++i) {
        const double power = power_of(sea_of(12.0 + 0.02 * i), 2);
        EXPECT_NEAR(power, before, 0.005 * before);
        before = power;
    }
}

TEST(FoamCover, ThePowerIsTheSameWhereverTheWindBlows) {
    Parameters parameters = sea_of(12.3);
    parameters.waves.front().wind_direction = 0.0;
    const double power = power_of(parameters, 2);
    for (const double direction : {30.0, 45.0, 90.0, 217.0}) {
        parameters.waves.front().wind_direction = direction;
        EXPECT_NEAR(power_of(parameters, 2), power, 0.005 * power) << direction;
    }
}

TEST(FoamCover, WithoutAPastItIsTheWhitecapAndOfACalmSeaNone) {
    Parameters parameters = sea_of(15.0);
    parameters.surface.foam_lifetime = 0.0;
    Ocean sea(parameters, {.threads = 1});
    const Surface now = sea.evaluate(3.0, {Channel::cover, Channel::whitecap});
    for (std::size_t i = 0; i < now.channel(Channel::cover).size(); ++i) {
        const float whitecap = now.channel(Channel::whitecap)[i];
        ASSERT_NEAR(now.channel(Channel::cover)[i], whitecap, 1e-6f * whitecap);
    }
    EXPECT_GT(mean_of(now, Channel::cover), 0.01);
    Parameters upright = sea_of(15.0);
    upright.surface.choppiness = 0.0;
    for (const Parameters& calm : {upright, sea_of(0.2)}) {
        Ocean still(calm, {.threads = 1});
        EXPECT_LT(mean_of(still.evaluate(3.0, {Channel::cover}), Channel::cover), 1e-5);
    }
}

TEST(FoamCover, FoamThatLivesLongAndShortLoopsHaveAPowerToo) {
    for (const double lifetime : {0.05, 40.0, 600.0}) {
        Parameters parameters = sea_of(12.3);
        parameters.surface.foam_lifetime = lifetime;
        const double power = power_of(parameters, 2);
        EXPECT_GE(power, 1.0) << lifetime;
        EXPECT_TRUE(std::isfinite(power)) << lifetime;
        parameters.time.loop_period = 8.0;
        EXPECT_GE(power_of(parameters, 2), 1.0) << lifetime;
    }
}

TEST(FoamCover, CoarserMapsAndAFrameAloneHaveTheSameMean) {
    Ocean sea(sea_of(12.3), {.threads = 2});
    const int resolutions[] = {128, 64, 32};
    const std::vector<Surface> levels =
        map_levels(sea, 7.0, {Channel::height, Channel::foam, Channel::cover}, resolutions);
    for (const Surface& level : levels) {
        EXPECT_NEAR(mean_of(level, Channel::cover) / mean_of(levels.front(), Channel::cover), 1.0,
                    1e-5);
    }
    Ocean other(sea_of(12.3), {.threads = 1});
    other.evaluate(6.0, {Channel::cover});
    EXPECT_TRUE(test::same_bits(levels.front(), other.evaluate(7.0, {Channel::cover})));
}

}  // namespace
}  // namespace ocean
