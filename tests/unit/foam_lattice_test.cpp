// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Foam on maps that are finer than its lattice: as much of it as the wind makes, the lattice's
// ticks alone to pay for, and the same bits however a frame is reached.

#include <ostream>

#include "ocean/internal/foam.hpp"
#include "ocean/parameter_table.hpp"
#include "test_seas.hpp"
#include "wave/wave.hpp"

namespace ocean {
namespace {

/// A sea of two cascades, whose map has four times the samples of its grid along each side.
Parameters two_cascades(int resolution, double patch, double wind) {
    return test::wind_sea(resolution, patch, {.wind = wind, .fetch = 30000.0, .cascades = 2});
}

TEST(FoamLattice, IsTheGridsUnlessTheMapIsCoarserOrAnotherIsSet) {
    Parameters parameters = two_cascades(64, 100.0, 14.0);
    EXPECT_EQ(foam_lattice(parameters, 256), (FoamLattice{64, 32}));
    EXPECT_EQ(foam_lattice(parameters, 64), (FoamLattice{64, 64}));
    EXPECT_EQ(foam_lattice(parameters, 32), (FoamLattice{32, 32}));
    parameters.surface.foam_resolution = 0;
    EXPECT_EQ(foam_lattice(parameters, 256), (FoamLattice{64, 32})) << "that of the grid";
    parameters.grid.cascades = 1;
    EXPECT_EQ(foam_lattice(parameters, 256), (FoamLattice{256, 256})) << "the map's own";
    parameters.surface.foam_resolution = 128;
    EXPECT_EQ(foam_lattice(parameters, 256), (FoamLattice{128, 64}));
    parameters.surface.foam_resolution = 1024;
    EXPECT_EQ(foam_lattice(parameters, 256), (FoamLattice{256, 256}));
}

TEST(FoamLattice, SpreadingKeepsItsCoverAndWraps) {
    constexpr int kLattice = 32, kMap = 128;
    constexpr double kPower = 3.2;
    std::vector<float> lattice(kLattice * kLattice);
    for (std::size_t i = 0; i < lattice.size(); ++i) {
        lattice[i] = 0.6f + 0.1f * static_cast<float>(i % 17) / 17.0f;
    }
    std::vector<float> map(kMap * kMap);
    spread_foam(lattice, kPower, map, test::pool());
    const auto cover = [](std::span<const float> foam) {
        double sum = 0.0;
        for (const float value : foam) sum += std::pow(static_cast<double>(value), kPower);
        return sum / static_cast<double>(foam.size());
    };
    EXPECT_NEAR(cover(map) / cover(lattice), 1.0, 1e-6);
    // Beyond the last column and row the first begin again: a shifted lattice is a shifted map.
    std::vector<float> shifted(lattice.size());
    for (const auto [i, j, at] : test::cells<std::size_t>(kLattice, kLattice)) {
        shifted[(j + 7) % kLattice * kLattice + (i + 30) % kLattice] = lattice[at];
    }
    std::vector<float> shifted_map(map.size());
    spread_foam(shifted, kPower, shifted_map, test::pool());
    for (const auto [i, j, at] : test::cells<std::size_t>(kMap, kMap)) {
        ASSERT_EQ(shifted_map[(j + 28) % kMap * kMap + (i + 120) % kMap], map[at]);
    }
}

TEST(FoamLattice, SpreadingIsACubicThroughTheCovers) {
    constexpr int kLattice = 32, kMap = 128;
    std::vector<float> lattice(kLattice * kLattice, 0.8f);
    lattice[8 * kLattice + 8] = 0.9f;
    std::vector<float> map(kMap * kMap);
    spread_foam(lattice, 2.0, map, test::pool());
    const auto cardinal = [](double x) {  // [Keys 1981], eq. 15: a = -1/2
        x = std::abs(x);
        if (x >= 2.0) return 0.0;
        return x < 1.0 ? 1.5 * x * x * x - 2.5 * x * x + 1.0
                       : -0.5 * x * x * x + 2.5 * x * x - 4.0 * x + 2.0;
    };
    for (const auto [i, j, at] : test::cells(kMap, kMap)) {
        const double expected = 0.64 + 0.17 * cardinal(i / 4.0 - 8.0) * cardinal(j / 4.0 - 8.0);
        const double cover = std::pow(map[at], 2.0);
        ASSERT_NEAR(cover, expected, 1e-6) << i << " " << j;
    }
    std::ranges::fill(lattice, 0.0f);
    lattice[8 * kLattice + 8] = 1.0f;
    spread_foam(lattice, 2.0, map, test::pool());
    EXPECT_EQ(*std::ranges::min_element(map), 0.0f) << "a cubic swings below";
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

struct Course {
    const char* name;
    double loop_period;  // s
    bool is_performed;
};
void PrintTo(const Course& course, std::ostream* out) {
    *out << course.name;
}

class FoamLatticeBits : public testing::TestWithParam<Course> {};

TEST_P(FoamLatticeBits, AreThoseOfAFrameAloneInSequence) {
    Sea course{two_cascades(32, 160.0, 14.0), {}};
    course.parameters.time.loop_period = GetParam().loop_period;
    if (GetParam().is_performed) {
        course.take.events = {{6.0, find_parameter("waves.0.wind_speed"), 17.0}};
    }
    const ChannelSet channels = {Channel::foam, Channel::cover, Channel::whitecap};
    const auto frame = [&](Ocean& sea, int number) {
        return sea.evaluate(sea.sea().time_of(number), channels);
    };
    Ocean alone(course, {.threads = 1});
    const Surface expected = frame(alone, 200);
    ASSERT_GT(expected.resolution(), course.parameters.grid.resolution);
    EXPECT_GT(test::variance(expected.channel(Channel::foam)), 1e-4) << "there is foam to compare";
    Ocean sequence(course, {.threads = 2});
    for (int number = 197; number < 200; ++number) frame(sequence, number);
    EXPECT_TRUE(test::same_bits(frame(sequence, 200), expected));
}

INSTANTIATE_TEST_SUITE_P(Each, FoamLatticeBits,
                         testing::Values(Course{"static", 0.0, false}, Course{"loop", 20.0, false},
                                         Course{"take", 0.0, true}));

TEST(FoamLattice, APastOfAllWavesOfTheMapHasThePowerOfTheMap) {
    Parameters parameters = two_cascades(64, 100.0, 14.0);
    const double layered = [&] {
        // No wave of the map is shorter than four samples of the lattice.
        Parameters calm = parameters;
        calm.surface.shortest_wavelength = 4.2 * 100.0 / 64.0;
        return Ocean(calm, {.threads = 2}).cover_power(0.0, 256);
    }();
    parameters.surface.shortest_wavelength = 4.2 * 100.0 / 64.0;
    parameters.surface.foam_resolution = 256;
    EXPECT_NEAR(layered, Ocean(parameters, {.threads = 2}).cover_power(0.0, 256), 0.01 * layered);
}

TEST(FoamLattice, ShortWhitecapsShowOnlyInYoungFoamOfLongWaves) {
    using wave::single_precision::foam_with_whitecap;
    EXPECT_EQ(foam_with_whitecap(0.8f, 0.0f, 0.0f), 0.0f);
    EXPECT_EQ(foam_with_whitecap(0.8f, 0.2f, 0.0f), 0.8f * 0.4f);
    EXPECT_EQ(foam_with_whitecap(0.8f, 0.5f, 0.0f), 0.8f);
    EXPECT_EQ(foam_with_whitecap(0.3f, 0.9f, 0.0f), 0.9f);
    EXPECT_EQ(foam_with_whitecap(0.8f, 0.1f, 1.0f), 0.8f) << "of the map's own foam: the maximum";
    Ocean sea(two_cascades(32, 160.0, 14.0), {.threads = 2});
    const Surface now = sea.evaluate(3.0, {Channel::foam, Channel::whitecap});
    int dots = 0;
    for (std::size_t i = 0; i < now.channel(Channel::foam).size(); ++i) {
        dots += now.channel(Channel::whitecap)[i] > 0.5f && now.channel(Channel::foam)[i] < 0.1f;
    }
    EXPECT_GT(dots, 0) << "whitecaps far from the long waves' foam exist, and are not shown";
}

TEST(FoamLattice, AThresholdThatIsGivenMakesAsManyWhitecapsInThePast) {
    Parameters parameters = two_cascades(64, 100.0, 14.0);
    parameters.surface.foam_coverage = FoamCoverage::threshold;
    parameters.surface.foam_threshold = 0.8;
    Ocean sea(parameters, {.threads = 2});
    const FoamLattice lattice = foam_lattice(parameters, 256);
    const SurfaceSettings past = lattice_settings(sea.modes(), parameters, lattice);
    const auto mean = [&](int held_by, double threshold) {
        return mean_whitecap(sea.modes().gradient_covariance(held_by),
                             parameters.surface.choppiness, threshold,
                             parameters.surface.foam_width);
    };
    const double whitecaps = mean(256, 0.8);
    EXPECT_GT(whitecaps, 1e-3);
    EXPECT_NEAR(mean(lattice.held_by, past.foam_threshold) / whitecaps, 1.0, 1e-6);
    EXPECT_EQ(lattice_settings(sea.modes(), parameters, {64, 64}).foam_threshold, 0.8);
}

/// A wind [m/s] and a number of seas: rare whitecaps need more of them.
using Weather = std::pair<double, int>;

class FoamLatticeCoverOf : public testing::TestWithParam<Weather> {};

TEST_P(FoamLatticeCoverOf, TheMeanCoverOfAFinerMapIsThatOfItsWhitecaps) {
    const auto [wind, seas] = GetParam();
    double cover = 0.0, whitecap = 0.0, closed_form = 0.0;
    Parameters parameters = two_cascades(128, 200.0, wind);
    for (int seed = 1; seed <= seas; ++seed) {
        parameters.seed = static_cast<std::uint32_t>(seed);
        Ocean sea(parameters, {.threads = 2});
        for (int i = 0; i < 12; ++i) {
            const Surface now = sea.evaluate(2.5 * i, {Channel::cover, Channel::whitecap});
            ASSERT_EQ(now.resolution(), 512);
            cover += test::mean(now.channel(Channel::cover));
            whitecap += test::mean(now.channel(Channel::whitecap));
            closed_form += monahan_coverage(wind);
        }
    }
    EXPECT_NEAR(cover / whitecap, 1.0, 0.025);
    EXPECT_NEAR(whitecap / closed_form, 1.0, 0.05);
}

INSTANTIATE_TEST_SUITE_P(Each, FoamLatticeCoverOf,
                         testing::Values(Weather{12.3, 8}, Weather{18.9, 6}, Weather{22.6, 6}));

}  // namespace
}  // namespace ocean
