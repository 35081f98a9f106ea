// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Caustics: flat water changes nothing, light is neither lost nor gained, crests focus where
// paraxial optics predicts, the sun's bearing and altitude shift the pattern, and the map depends
// neither on threads nor on where its period begins.
#include "ocean/internal/caustics.hpp"

#include "ocean/error.hpp"
#include "ocean/internal/make_surface.hpp"
#include "ocean/internal/water_types.hpp"
#include "ocean/thread_pool.hpp"
#include "test_seas.hpp"

namespace ocean {
namespace {

constexpr double kDegree = kTwoPi / 360.0;

std::vector<float> caustics_of(const Surface& surface, const CausticsSettings& settings,
                               int threads = 1) {
    ThreadPool pool(threads);
    return make_caustics(surface, settings, pool);
}

/// Crests a cos(k x) along y, `waves` of them in a period; points are moved by -squeeze sin(k x).
Surface crests(int n, double period, double a, int waves = 1, double squeeze = 0.0) {
    Surface surface(Lattice{n, period}, 0.0, kCausticsChannels);
    const double k = kTwoPi * waves / period;
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) {
            const auto at = static_cast<std::size_t>(j * n + i);
            const double phase = k * period * i / n;
            const double run = 1.0 - squeeze * k * std::cos(phase), rise = -a * k * std::sin(phase);
            const auto put = [&](Channel channel, double value) {
                surface.channel(channel)[at] = static_cast<float>(value);
            };
            put(Channel::dx, -squeeze * std::sin(phase));
            put(Channel::dy, 0.0);
            put(Channel::height, a * std::cos(phase));
            put(Channel::nx, -rise / std::hypot(run, rise));
            put(Channel::ny, 0.0);
            put(Channel::nz, run / std::hypot(run, rise));
        }
    }
    return surface;
}

Surface wind_sea(int n = 128) {
    const Parameters parameters = test::wind_sea(n, 60.0);
    const Modes modes = make_modes(make_directional_spectrum(parameters), parameters, test::pool());
    return make_surface(modes, parameters.surface, 3.0, kCausticsChannels, Backend::cpu,
                        test::pool());
}

TEST(Caustics, FlatWaterHasOneEverywhere) {
    const Surface flat = crests(32, 7.0, 0.0);
    for (const CausticsSettings& settings :
         {CausticsSettings{}, CausticsSettings{2.3, 35.0, 70.0},
          CausticsSettings{0.01, 5.0, -200.0}, CausticsSettings{100.0, 60.0, 180.0}}) {
        for (const float value : caustics_of(flat, settings)) ASSERT_NEAR(value, 1.0, 1e-6);
    }
}

// Samples that choppiness has moved together carry less light each.
TEST(Caustics, MovingTheSamplesOfFlatWaterChangesNothing) {
    const Surface flat = crests(64, kTwoPi, 0.0, 2, 0.3);
    for (const CausticsSettings& settings :
         {CausticsSettings{}, CausticsSettings{3.0, 40.0, 10.0}}) {
        for (const float value : caustics_of(flat, settings)) ASSERT_NEAR(value, 1.0, 1e-5);
    }
}

// Also where crests have folded over (squeeze k > 1).
TEST(Caustics, TheMeanIsOne) {
    for (const CausticsSettings& settings :
         {CausticsSettings{4.0}, CausticsSettings{20.0, 40.0, 250.0}}) {
        const std::vector<float> sea = caustics_of(wind_sea(), settings);
        EXPECT_NEAR(test::mean(sea), 1.0, 1e-6);
        EXPECT_GT(test::variance(sea), 0.02);
        EXPECT_GE(*std::min_element(sea.begin(), sea.end()), 0.0f);
        EXPECT_NEAR(test::mean(caustics_of(crests(64, kTwoPi, 0.3, 1, 1.4), settings)), 1.0, 1e-6);
    }
}

// [caustics.cpp]: 1 / (1 - d / f) below a crest and 1 / (1 + d / f) below a trough.
TEST(Caustics, AWaveHasItsFocusWhereParaxialOpticsPutsIt) {
    constexpr int n = 512;
    constexpr double period = 4.0, a = 0.02, k = kTwoPi / period;
    constexpr double focus = kWaterIor / (kWaterIor - 1.0) / (a * k * k);
    const Surface wave = crests(n, period, a);
    const auto below = [&](double depth, double level, int i) {
        return static_cast<double>(
            caustics_of(wave, {depth - level})[static_cast<std::size_t>(17 * n + i)]);
    };
    for (const double part : {0.2, 0.4, 0.6}) {
        const double depth = part * focus;
        EXPECT_NEAR(below(depth, a, 0) * (1.0 - part), 1.0, 0.001) << part;
        EXPECT_NEAR(below(depth, -a, n / 2) * (1.0 + part), 1.0, 0.001) << part;
    }
    // The brightest line of all depths. A cell's width moves it 2 % down.
    double brightest = 0.0, at = 0.0;
    for (const double part : {0.9, 0.96, 1.0, 1.02, 1.04, 1.1}) {
        const std::vector<float> light = caustics_of(wave, {part * focus - a});
        if (light[0] <= brightest) continue;
        brightest = light[0];
        at = part;
        EXPECT_EQ(std::max_element(light.begin(), light.begin() + n) - light.begin(), 0) << part;
    }
    EXPECT_GT(brightest, 50.0);
    EXPECT_NEAR(at, 1.02, 0.025);
}

// sin of the refracted ray's angle to the vertical is cos(altitude) / n [Snell].
TEST(Caustics, ALowSunShiftsTheLightAwayFromItself) {
    constexpr int n = 128;
    constexpr double period = 4.0, depth = 4.0;
    const Surface wave = crests(n, period, 0.01);
    for (const double altitude : {90.0, 75.0, 60.0}) {
        for (const double bearing : {0.0, 180.0, 60.0}) {
            const std::vector<float> light = caustics_of(wave, {depth, altitude, bearing});
            std::complex<double> first = 0.0;
            for (int i = 0; i < n; ++i) {
                first += std::polar(static_cast<double>(light[static_cast<std::size_t>(i)]),
                                    kTwoPi * i / n);
            }
            const double refracted = std::asin(std::cos(altitude * kDegree) / kWaterIor);
            const double shift = -depth * std::tan(refracted) * std::cos(bearing * kDegree);
            const double found = std::arg(first) / kTwoPi * period;
            EXPECT_NEAR(std::remainder(found - shift, period), 0.0, 0.06) << altitude << bearing;
        }
    }
    // The same sun on crests along x: bearings are counter-clockwise from +x.
    const std::vector<float> east = caustics_of(wave, {depth, 60.0, 90.0});
    const std::vector<float> zenith = caustics_of(wave, {depth});
    EXPECT_EQ(std::max_element(east.begin(), east.begin() + n) - east.begin(),
              std::max_element(zenith.begin(), zenith.begin() + n) - zenith.begin());
}

TEST(Caustics, AreTheSameForAnyNumberOfThreads) {
    const Surface sea = wind_sea();
    const CausticsSettings settings{8.0, 50.0, 20.0};
    const std::vector<float> alone = caustics_of(sea, settings);
    for (const int threads : {2, 3, 8}) EXPECT_EQ(caustics_of(sea, settings, threads), alone);
}

// So the map has no seam: where it is cut is not seen in any bit.
TEST(Caustics, ShiftWithTheSurface) {
    const Surface sea = wind_sea();
    const int n = sea.resolution();
    const auto moved = [n](int i, int j) {
        return static_cast<std::size_t>((j + 77) % n * n + (i + 5) % n);
    };
    Surface other(Lattice{n, sea.period()}, 0.0, kCausticsChannels);
    for (const Channel channel : test::channels_of(other)) {
        for (const auto [i, j, at] : test::cells(n, n)) {
            other.channel(channel)[moved(i, j)] = sea.channel(channel)[at];
        }
    }
    const CausticsSettings settings{12.0, 45.0, 130.0};
    const std::vector<float> here = caustics_of(sea, settings),
                             there = caustics_of(other, settings);
    for (const auto [i, j, at] : test::cells(n, n)) {
        ASSERT_EQ(here[at], there[moved(i, j)]) << i << j;
    }
}

TEST(Caustics, RefuseWhatTheyCannotBe) {
    const Surface flat = crests(32, 7.0, 0.0);
    for (const CausticsSettings& settings :
         {CausticsSettings{0.0}, CausticsSettings{101.0}, CausticsSettings{1.0, 4.0},
          CausticsSettings{1.0, 91.0}, CausticsSettings{1.0, 90.0, NAN}}) {
        EXPECT_THROW(caustics_of(flat, settings), Error);
    }
    EXPECT_THROW(caustics_of(Surface(Lattice{32, 7.0}, 0.0, {Channel::height}), {}), Error);
}

}  // namespace
}  // namespace ocean
