// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The foam of whole seas: the same bits however a frame is reached, as white as the wind makes it,
// and closed in a loop. The clock and the coverage by themselves: foam_test.cpp.

#include "ocean/internal/foam.hpp"
#include "test_seas.hpp"

namespace ocean {
namespace {

constexpr ChannelSet kFoam = {Channel::foam};

Parameters foamy_sea(int resolution, double patch, double wind) {
    return test::wind_sea(resolution, patch, {.wind = wind, .fetch = 300000.0});
}

std::vector<float> foam_of(Ocean& sea, double frame) {
    return test::values_of(sea.evaluate(sea.sea().time_of(frame), kFoam), Channel::foam);
}

TEST(SeaFoam, FrameTwoHundredHasTheSameBitsHoweverItIsReached) {
    const Parameters parameters = foamy_sea(32, 80.0, 14.0);
    Ocean alone(parameters, {.threads = 1});
    const std::vector<float> expected = foam_of(alone, 200);
    EXPECT_GT(test::variance(expected), 1e-4) << "there is foam to compare";

    const auto from = [&](int first, int threads) {
        Ocean sea(parameters, {.threads = threads});
        std::vector<float> foam;
        for (int frame = first; frame <= 200; ++frame) foam = foam_of(sea, frame);
        return foam;
    };
    EXPECT_EQ(from(1, 1), expected);
    EXPECT_EQ(from(150, 2), expected);

    Ocean backward(parameters, {.threads = 1});
    foam_of(backward, 201);
    const int ticks = backward.stage_runs().foam_ticks;
    EXPECT_EQ(foam_of(backward, 200), expected);
    EXPECT_EQ(backward.stage_runs().foam_ticks, ticks) << "a step back within two ticks is free";

    for (const double fps : {48.0, 96.0}) {
        Parameters faster = parameters;
        faster.time.fps = fps;
        Ocean sea(faster, {.threads = 1});
        std::vector<float> foam;
        const int same_moment = 1 + static_cast<int>(199 * fps / 24.0);
        for (int frame = same_moment - 10; frame <= same_moment; ++frame) {
            foam = foam_of(sea, frame);
        }
        EXPECT_EQ(foam, expected) << fps << " frames per second";
    }
}

int kernel_runs = 0;
bool kernel_stops = false;
struct Stopped {};

/// Returns the cpu backend, which counts its runs and may stop at the end of one.
Backend counting_backend(bool keeps_foam) {
    Backend backend = Backend::cpu;
    backend.keeps_foam = keeps_foam;
    backend.start = [] {
        return MapFunction(
            [cpu = Backend::cpu.start()](const MapRequest& request, ThreadPool& pool) {
                ++kernel_runs;
                const bool packed = cpu(request, pool);
                if (kernel_stops) throw Stopped{};
                return packed;
            });
    };
    return backend;
}

TEST(SeaFoam, AMapAtATickIsOneRunOfTheKernelWithTheBitsOfTwo) {
    static const ChannelInfo kTwice[] = {
        {"twice",
         "",
         channel_info(Channel::foam).choppy,
         {},
         [](const auto& point) { return 2 * channel_formula::foam_of(point); },
         FoamUse::past}};
    struct Case {
        const char* name;
        ChannelSet channels;
        int runs;          // at a tick
        int runs_between;  // with a tick before
        std::function<void(Parameters&)> change = [](Parameters&) {};
    };
    using enum Channel;
    const Case cases[] = {
        {"foam", {foam}, 1, 2},
        {"cover", {height, cover}, 1, 2},
        {"a host's foam", {foam, static_cast<Channel>(kChannelCount)}, 2, 2},
        {"a lattice", {dx, foam}, 2, 3, [](Parameters& p) { p.surface.foam_resolution = 32; }},
        {"bound waves", {foam}, 1, 2, [](Parameters& p) { p.surface.second_order = true; }},
        {"a loop", {foam, whitecap}, 1, 2, [](Parameters& p) { p.time.loop_period = 3.0; }},
    };
    for (const Case& c : cases) {
        Parameters parameters = foamy_sea(64, 120.0, 14.0);
        parameters.surface.foam_lifetime = 0.5;
        c.change(parameters);
        const auto sea = [&](bool keeps_foam) {
            return Ocean(
                parameters,
                {.threads = 1, .backend = counting_backend(keeps_foam), .channels = kTwice});
        };
        Ocean once = sea(true);
        Ocean twice = sea(false);
        once.evaluate(0.0, c.channels);
        twice.evaluate(0.0, c.channels);
        for (int frame = 1; frame <= 8; ++frame) {
            // Each fourth frame lies between two ticks.
            const double time = frame * 0.05 + (frame % 4 == 0 ? 0.02 : 0.0);
            const int ticks = once.stage_runs().foam_ticks;
            kernel_runs = 0;
            const Surface map = once.evaluate(time, c.channels);
            EXPECT_EQ(kernel_runs, frame % 4 == 0 ? c.runs_between : c.runs)
                << c.name << ", frame " << frame;
            EXPECT_EQ(once.stage_runs().foam_ticks, ticks + 1);
            EXPECT_TRUE(test::same_bits(map, twice.evaluate(time, c.channels)))
                << c.name << ", frame " << frame;
            EXPECT_GT(test::variance(map.channel(c.channels.contains(foam) ? foam : cover)), 1e-5);
        }
        EXPECT_EQ(once.stage_runs(), twice.stage_runs()) << c.name;
    }
}

TEST(SeaFoam, AMapThatIsStoppedKeepsNoTick) {
    const Parameters parameters = foamy_sea(64, 120.0, 14.0);
    Ocean sea(parameters, {.threads = 1, .backend = counting_backend(true)});
    Ocean other(parameters, {.threads = 1});
    sea.evaluate(0.0, kFoam);
    const int ticks = sea.stage_runs().foam_ticks;
    kernel_stops = true;
    EXPECT_THROW(sea.evaluate(0.05, kFoam), Stopped);
    EXPECT_EQ(sea.stage_runs().foam_ticks, ticks);
    kernel_stops = false;
    for (const double time : {0.05, 0.07}) {
        EXPECT_TRUE(test::same_bits(sea.evaluate(time, kFoam), other.evaluate(time, kFoam)));
    }
}

TEST(SeaFoam, IsNeverLessThanTheWhitecapsAndFadesWithItsLifetime) {
    Parameters parameters = foamy_sea(64, 100.0, 14.0);
    parameters.surface.foam_lifetime = 2.0;
    Ocean sea(parameters, {.threads = 2});
    const ChannelSet both = {Channel::foam, Channel::whitecap};
    const Surface now = sea.evaluate(10.0, both);
    const Surface later = sea.evaluate(10.02, both);
    const float fading = std::exp(-0.02f / 2.0f);
    for (std::size_t i = 0; i < now.channel(Channel::foam).size(); ++i) {
        EXPECT_GE(now.channel(Channel::foam)[i], now.channel(Channel::whitecap)[i]);
        EXPECT_LE(now.channel(Channel::foam)[i], 1.0f);
        const float least = now.channel(Channel::foam)[i] * fading;
        if (least > 0.01f) {
            EXPECT_GT(later.channel(Channel::foam)[i], least * 0.97f);
        }
    }
    parameters.surface.foam_lifetime = 0.0;
    Ocean brief(parameters, {.threads = 2});
    const Surface moment = brief.evaluate(10.0, both);
    EXPECT_EQ(test::values_of(moment, Channel::foam), test::values_of(moment, Channel::whitecap));
    EXPECT_LE(brief.stage_runs().foam_ticks, 1) << "there is no past to follow";
}

/// Returns a sea whose height and period are given, and its wind is not.
Parameters swell(double height, double period) {
    Parameters parameters;
    parameters.grid.resolution = 64;
    WaveSystem& system = parameters.waves.front();
    system.spectrum = SpectrumKind::jonswap;
    system.significant_wave_height = height;
    system.peak_period = period;
    return parameters;
}

constexpr const char* kNoWind = "the wind is unknown";

TEST(SeaFoam, ASwellHasNoneUntilAWindIsGiven) {
    Ocean sea(swell(1.0, 14.0), {.threads = 1});
    const auto whitest = [&](double time) {
        const Surface surface = sea.evaluate(time, {Channel::foam, Channel::whitecap});
        return std::ranges::max(surface.channel(Channel::foam));
    };
    const auto heights = [&] { return test::values_of(sea.evaluate(5.0, {Channel::height})); };
    EXPECT_EQ(whitest(5.0), 0.0f);
    EXPECT_EQ(sea.state().whitecap_coverage.asked, 0.0);
    EXPECT_EQ(sea.state().whitecap_coverage.resolved, 0.0);
    EXPECT_TRUE(test::says(sea.state().warnings, kNoWind));
    const std::vector<float> unset = heights();

    sea.set("wind_speed", "10");
    EXPECT_EQ(heights(), unset) << "the waves are those of before";
    EXPECT_GT(whitest(5.0), 0.1f);
    EXPECT_EQ(sea.state().whitecap_coverage.asked, monahan_coverage(10.0));
    EXPECT_FALSE(test::says(sea.state().warnings, kNoWind));

    sea.set("wind_speed", "");
    EXPECT_EQ(whitest(5.0), 0.0f);
    sea.perform(6.0, "wind_speed", "12");
    EXPECT_EQ(whitest(5.0), 0.0f);
    EXPECT_EQ(whitest(6.0), 0.0f);
    EXPECT_GT(whitest(16.0), 0.1f);
    EXPECT_EQ(sea.modes(60.0).wind_speed, 12.0);
    EXPECT_FALSE(test::says(sea.state().warnings, kNoWind)) << "the take brings one";

    Ocean asked(swell(1.0, 14.0), {.threads = 1});
    asked.set("foam_coverage", "threshold");
    EXPECT_FALSE(test::says(asked.state().warnings, kNoWind)) << "no wind has a say in it";
}

TEST(SeaFoam, ItsWindIsTheStrongestThatIsKnownOf) {
    const auto wind = [&](const Parameters& p) { return test::modes_of(p).wind_speed; };
    Parameters parameters = swell(1.0, 14.0);
    EXPECT_EQ(wind(parameters), 0.0);
    WaveSystem young;
    young.spectrum = SpectrumKind::jonswap;
    parameters.waves.push_back(young);
    EXPECT_EQ(wind(parameters), 10.0) << "a wind sea without a wind_speed";
    parameters.waves.back().wind_speed = 5.0;
    EXPECT_EQ(wind(parameters), 5.0) << "the swell has no say";
    parameters.waves.front().wind_speed = 8.0;
    EXPECT_EQ(wind(parameters), 8.0);
    // A height alone leaves the period to the wind, and the other way round.
    parameters = swell(1.0, 14.0);
    parameters.waves.front().peak_period.reset();
    EXPECT_EQ(wind(parameters), 10.0);
    parameters = swell(1.0, 14.0);
    parameters.waves.front().significant_wave_height.reset();
    EXPECT_EQ(wind(parameters), 10.0);
}

TEST(SeaFoam, HalvingItsStepChangesItByLessThanFourPercent) {
    struct Case {
        double wind, patch;
        int resolution;
    };
    for (const Case& c : {Case{12.0, 150.0, 256}, Case{12.0, 75.0, 256}, Case{20.0, 300.0, 256}}) {
        Parameters parameters = foamy_sea(c.resolution, c.patch, c.wind);
        const auto foam_with_step = [&](double step) {
            parameters.surface.foam_step = step;
            Ocean sea(parameters, {.threads = 2});
            return foam_of(sea, 1);
        };
        const std::vector<float> normal = foam_with_step(0.05);
        const std::vector<float> fine = foam_with_step(0.025);
        const double relative = test::rms(test::difference(normal, fine)) / test::rms(fine);
        EXPECT_LT(relative, 0.04) << c.wind << " m/s, " << c.patch << " m";
        EXPECT_GT(relative, 1e-4) << "the steps differ";
    }
}

TEST(SeaFoam, ACalmOrUprightSeaHasNone) {
    Parameters calm = foamy_sea(32, 100.0, 0.0);
    Parameters upright = foamy_sea(32, 100.0, 15.0);
    upright.surface.choppiness = 0.0;
    for (const Parameters& parameters : {calm, upright}) {
        Ocean sea(parameters, {.threads = 1});
        const Surface map = sea.evaluate(5.0, {Channel::foam, Channel::whitecap});
        EXPECT_EQ(std::ranges::max(map.channel(Channel::foam)), 0.0f);
        EXPECT_EQ(std::ranges::max(map.channel(Channel::whitecap)), 0.0f);
    }
}

TEST(SeaFoam, AFixedThresholdIsTakenAsItIs) {
    Parameters parameters = foamy_sea(64, 100.0, 14.0);
    parameters.surface.foam_coverage = FoamCoverage::threshold;
    parameters.surface.foam_threshold = 0.8;
    parameters.surface.foam_width = 0.5;
    Ocean sea(parameters, {.threads = 1});
    const Surface map = sea.evaluate(5.0, {Channel::jacobian, Channel::whitecap});
    for (std::size_t i = 0; i < map.channel(Channel::jacobian).size(); ++i) {
        const double expected =
            std::min(std::max((0.8 - map.channel(Channel::jacobian)[i]) / 0.5, 0.0), 1.0);
        EXPECT_NEAR(map.channel(Channel::whitecap)[i], expected, 1e-6);
    }
}

TEST(SeaFoam, ALoopClosesInEveryFieldAndNoWaveStandsStill) {
    Parameters parameters = foamy_sea(32, 80.0, 14.0);
    parameters.grid.cascades = 2;
    parameters.time.loop_period = 3.1;  // shorter than foam lives, no whole number of ticks
    const ChannelSet all = test::kAllChannels | kFoam | Channel::cover;
    for (const double time : {0.0, 0.1, 1.0 / 24.0, 2.9}) {
        Ocean first(parameters, {.threads = 1});
        Ocean second(parameters, {.threads = 2});
        const Surface now = first.evaluate(time, all);
        EXPECT_TRUE(test::same_bits(second.evaluate(time + 3.1, all), now)) << time;
        EXPECT_TRUE(test::same_bits(first.evaluate(time + 3.1 * 1024.0, all), now)) << time;
        EXPECT_GT(test::variance(now.channel(Channel::foam)), 1e-5) << "there is foam to compare";
    }
    Ocean sea(parameters, {.threads = 1});
    for (const CascadeModes& cascade : sea.modes().cascades) {
        for (std::size_t i = 0; i < cascade.h0.size(); ++i) {
            if (std::norm(cascade.h0[i]) > 0.0f) {
                EXPECT_GE(cascade.rate_high[i], 1.0f);
            }
        }
    }
}

TEST(SeaFoam, FramesOfATakeAreTheSameAloneAndInSequence) {
    Sea sea{foamy_sea(32, 80.0, 9.0), {}};
    sea.parameters.surface.foam_lifetime = 1.0;
    sea.take.events = {{0.5, find_parameter("wind_speed"), 16.0},
                       {0.9, find_parameter("choppiness"), 1.3},
                       {1.0, find_parameter("wind_direction"), -70.0},
                       {1.4, find_parameter("foam_lifetime"), 0.4},
                       {1.9, find_parameter("wind_speed"), 11.0}};
    const ChannelSet all = test::kAllChannels | kFoam | Channel::cover;
    Ocean sequence(sea, {.threads = 2});
    for (int frame = 1; frame <= 60; ++frame) {
        const double time = sea.time_of(frame);
        if (frame % 12 != 0) {
            sequence.evaluate(time, kFoam);
            continue;
        }
        Ocean alone(sea, {.threads = 1});
        EXPECT_TRUE(test::same_bits(alone.evaluate(time, all), sequence.evaluate(time, all)))
            << frame;
    }
    // The comparison covers the performance, and at its end nothing is built again.
    EXPECT_GT(sequence.stage_runs().spectrum, 40);
    sequence.evaluate(100.0, {Channel::height});
    const StageRuns settled = sequence.stage_runs();
    sequence.evaluate(101.0, {Channel::height});
    EXPECT_EQ(sequence.stage_runs().spectrum, settled.spectrum);
    EXPECT_EQ(sequence.stage_runs().modes, settled.modes);
}

}  // namespace
}  // namespace ocean
