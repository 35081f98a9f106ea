// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Waves that glide slowly: their amplitudes are interpolated between two states of the sea.
#include <set>

#include "ocean/internal/kernel_backends.hpp"
#include "test_seas.hpp"

namespace ocean {
namespace {

struct Glide {
    const char* name;
    double from;
    double to;
    double patch_size = 500.0;
};

/// A sea whose parameter glides by half a second's filter from time 0 on.
Sea gliding_sea(const Parameters& parameters, const Glide& glide) {
    Sea sea{parameters};
    const ParameterRef ref = find_parameter(glide.name);
    assign(sea.parameters, ref, glide.from);
    sea.take.events = {{0.0, ref, glide.to}};
    validate(sea);
    return sea;
}

/// Returns a time at which the share of a passage is near a half; none if there is none.
std::optional<double> middle_of_passage(const Sea& sea) {
    for (double time = 0.0; time < 5.0; time += 0.005) {
        const auto passage = sea.passage(time);
        if (passage && std::abs(passage->share - 0.5) < 0.1) return time;
    }
    return std::nullopt;
}

TEST(Passage, KeepsTheSurfaceToAThousandthAndInLightWindsToThree) {
    constexpr Glide kGlides[] = {
        {"wind_speed", 10.0, 11.0},
        {"wind_speed", 25.0, 24.0},
        {"fetch", 1e5, 1.2e5},
        {"fetch", 2e3, 1.8e3},
        {"peak_enhancement", 6.0, 7.0},
        {"peak_enhancement", 2.0, 2.6},
        {"swell", 0.3, 0.45},
        {"swell", -0.5, -0.35},
        {"significant_wave_height", 2.0, 2.6},
        {"peak_period", 8.0, 8.4},
        {"wind_direction", 30.0, 38.0},
        {"wind_direction", -178.0, 177.0},
        {"wind_speed", 2.0, 2.3, 60.0},
    };
    for (const SpectrumKind kind : {SpectrumKind::jonswap, SpectrumKind::pierson_moskowitz}) {
        for (const bool narrow : {false, true}) {
            Parameters parameters = test::wind_sea(128, 500.0, {.wind = 12.0, .spectrum = kind});
            if (narrow) {
                parameters.waves.front().swell = 1.0;
                parameters.waves.front().peak_enhancement = 7.0;
                parameters.waves.front().peak_period = 9.0;
            }
            for (const Glide& glide : kGlides) {
                parameters.grid.patch_size = glide.patch_size;
                const Sea sea = gliding_sea(parameters, glide);
                const auto time = middle_of_passage(sea);
                ASSERT_TRUE(time) << glide.name << " from " << glide.from;
                const bool light = sea.at(*time).waves.front().wind() < 5.0;
                Ocean playing(sea), resting(sea.at(*time));
                const auto height = test::values_of(resting.evaluate(*time, {Channel::height}));
                const auto error = test::difference(
                    test::values_of(playing.evaluate(*time, {Channel::height})), height);
                EXPECT_LT(test::rms(error), (light ? 3e-3 : 1e-3) * test::rms(height))
                    << glide.name << " from " << glide.from << ", spectrum "
                    << static_cast<int>(kind) << (narrow ? ", narrow" : "");
            }
        }
    }
}

TEST(Passage, IsOfOneNumberOfTheWavesThatGlidesSlowly) {
    const Parameters parameters = test::wind_sea(32, 200.0, {.wind = 10.0});
    const Sea slow = gliding_sea(parameters, {"wind_speed", 10.0, 11.0});
    const auto time = middle_of_passage(slow);
    ASSERT_TRUE(time);
    const Passage passage = *slow.passage(*time);
    const auto wind = [](const Parameters& state) { return state.waves.front().wind(); };
    EXPECT_NEAR(wind(passage.to) / wind(passage.from), 1.0175, 1e-12);
    EXPECT_NEAR(wind(passage.from) + passage.share * (wind(passage.to) - wind(passage.from)),
                wind(slow.at(*time)), 1e-12);
    // At rest, and while it passes a step a frame.
    EXPECT_FALSE(slow.passage(-1.0));
    EXPECT_FALSE(slow.passage(60.0));
    EXPECT_FALSE(gliding_sea(parameters, {"wind_speed", 10.0, 40.0}).passage(0.1));
    // The choppiness is of the surface and does not count; a second number and a mix do.
    const auto with = [&](const char* name, ParameterValue value) {
        Sea sea = slow;
        sea.take.events.push_back({0.0, find_parameter(name), std::move(value)});
        return sea.passage(*time).has_value();
    };
    EXPECT_TRUE(with("choppiness", 0.5));
    EXPECT_TRUE(with("spreading", "hasselmann"));
    EXPECT_FALSE(with("swell", 0.1));
    EXPECT_FALSE(with("spreading", "mitsuyasu"));
    // A wind that begins brings its whitecaps too.
    Parameters calm = test::wind_sea(32, 200.0, {.height = 2.0, .period = 7.0});
    const Sea rising{calm, {{{0.0, find_parameter("wind_speed"), 10.5}}, {}}};
    for (double t = 0.05; t < 5.0; t += 0.05) EXPECT_FALSE(rising.passage(t));
    Sea bound = slow;
    bound.parameters.surface.second_order = true;
    EXPECT_FALSE(bound.passage(*time));
}

TEST(Passage, MakesAStateForEachStepAndNotForEachFrame) {
    Ocean live(gliding_sea(test::wind_sea(64, 200.0, {.wind = 10.0}), {"wind_speed", 10.0, 10.6}),
               {.threads = 1});
    std::set<double> steps;
    for (int frame = 30; frame < 240; ++frame) {
        const double time = frame / 60.0;
        const auto passage = live.sea().passage(time);
        ASSERT_TRUE(passage) << time;
        steps.insert({passage->from.waves.front().wind(), passage->to.waves.front().wind()});
        live.evaluate(time, {Channel::height, Channel::whitecap});
    }
    EXPECT_LT(steps.size(), 6u);  // from 10.38 to 10.6 m/s
    const int states = static_cast<int>(steps.size());
    EXPECT_EQ(live.stage_runs().spectrum, states);
    EXPECT_EQ(live.stage_runs().modes, states);
    EXPECT_EQ(live.stage_runs().packing, states - 1);  // the first two at once
}

TEST(Passage, HasTheSameBitsInEveryOrderWithEveryInstructionSetAndAsManyThreads) {
    for (const int cascades : {1, 2}) {
        const Sea sea = gliding_sea(test::wind_sea(64, 200.0, {.wind = 10.0, .cascades = cascades}),
                                    {"wind_speed", 10.0, 11.0});
        constexpr ChannelSet kShown = {Channel::dx, Channel::height, Channel::whitecap};
        // At time 0 the number is that of rest, and glides.
        Ocean forth(sea, {.threads = 1});
        std::vector<Surface> frames;
        const std::vector<double> times = {-1.0, 0.0, 0.3, 0.7, 2.5};
        for (const double time : times) frames.push_back(forth.evaluate(time, kShown, 64));
        for (const Backend& backend : kernel_backends()) {
            Ocean back(sea, {.threads = 2, .backend = backend});
            for (std::size_t i = times.size(); i-- > 0;) {
                EXPECT_TRUE(test::same_bits(back.evaluate(times[i], kShown, 64), frames[i]))
                    << backend.name << " at " << times[i];
                Ocean copy(back, {.threads = 1});
                EXPECT_TRUE(test::same_bits(copy.evaluate(times[i], kShown, 64), frames[i]));
                const auto amplitudes = [&](Ocean& ocean) {
                    return ocean.modes(times[i]).cascades.back().h0;
                };
                EXPECT_EQ(amplitudes(copy), amplitudes(back));
            }
        }
    }
}

TEST(Passage, IsInterpolatedAlikeForBackendsThatCannot) {
    const Sea sea = gliding_sea(test::wind_sea(32, 200.0, {.wind = 10.0, .cascades = 2}),
                                {"wind_speed", 10.0, 11.0});
    const double time = *middle_of_passage(sea);
    Ocean fast(sea), reference(sea, {.backend = Backend::dft});
    const auto expected = test::values_of(reference.evaluate(time, {Channel::height}));
    EXPECT_LT(test::rms(test::difference(test::values_of(fast.evaluate(time, {Channel::height})),
                                         expected)),
              1e-6 * test::rms(expected));
    // A query sums the modes of the sea.
    const WorldPoint point[] = {{12.0, 34.0}};
    const double asked = test::query(fast, time, point, {.exact = true}).front().height;
    EXPECT_NEAR(asked, test::query(reference, time, point, {.exact = true}).front().height, 1e-6);
}

}  // namespace
}  // namespace ocean
