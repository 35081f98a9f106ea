// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A sea that is played live: its take reproduces what was displayed, and the past stays.

#include <iterator>

#include "refusal.hpp"
#include "test_seas.hpp"

namespace ocean {
namespace {

constexpr double kFrame = 1.0 / 60.0;
constexpr int kMap = 64;

Parameters played_sea() {
    Parameters parameters = test::wind_sea(64, 200.0);
    parameters.surface.foam_lifetime = 1.0;
    return parameters;
}

std::vector<float> shown(Ocean& ocean, double time, int resolution = kMap) {
    const Surface map = ocean.evaluate(time, {Channel::height, Channel::foam}, resolution);
    std::vector<float> values = test::values_of(map);
    std::ranges::copy(map.channel(Channel::foam), std::back_inserter(values));
    return values;
}

std::string refusal(Ocean& ocean, double time, const std::string& name, const std::string& value) {
    const auto refused = test::refusal_of([&] { ocean.perform(time, name, value); });
    EXPECT_EQ(refused.kind, ErrorKind::invalid_value);
    return refused.message;
}

TEST(Perform, EveryFrameThatWasShownIsMadeAgainByTheTakeInEveryBit) {
    Ocean live(played_sea(), {.threads = 2});
    constexpr int kFrames = 100;
    std::vector<std::vector<float>> frames;
    for (int frame = 0; frame < kFrames; ++frame) {
        const double time = frame * kFrame;
        // A knob that is turned up, rests, and is turned back in a burst within one frame.
        if (frame >= 10 && frame < 40) {
            live.perform(time, "wind_speed", std::to_string(8.0 + 0.2 * (frame - 10)));
        }
        for (int i = 0; frame == 60 && i < 8; ++i) {
            live.perform(time + i * 1e-3, "wind_speed", std::to_string(14.0 - i));
            live.perform(time + i * 1e-3, "choppiness", std::to_string(1.0 + 0.1 * i));
        }
        if (frame == 75) live.perform(time, "foam_lifetime", "3");
        if (frame == 80) live.perform(time, "spreading", "mitsuyasu");
        frames.push_back(shown(live, time));
    }
    Ocean again(live.sea(), {.threads = 1});
    for (const int frame : {99, 0, 9, 10, 11, 25, 59, 60, 61, 62, 75, 76, 80, 81}) {
        Ocean alone(live.sea(), {.threads = 1});
        EXPECT_EQ(shown(alone, frame * kFrame), frames[static_cast<std::size_t>(frame)]) << frame;
    }
    for (int frame = 0; frame < kFrames; ++frame) {
        EXPECT_EQ(shown(again, frame * kFrame), frames[static_cast<std::size_t>(frame)]) << frame;
    }
    const Parameters end = live.sea().at(60.0);
    EXPECT_EQ(end.waves.front().wind_speed, 7.0);  // the last of the burst
    EXPECT_NEAR(end.surface.choppiness, 1.7, 1e-12);
}

TEST(Perform, MovesTheSeaLessInAFrameThanItsWavesDoAndSetJumps) {
    // 8 to 14 m/s, the step that jumped by half a metre when it was set.
    Parameters parameters = test::wind_sea(128, 400.0, {.wind = 8.0});
    const auto heights = [](Ocean& ocean, double time) {
        return test::values_of(ocean.evaluate(time, {Channel::height}));
    };
    const auto moved = [](const std::vector<float>& a, const std::vector<float>& b) {
        return test::rms(test::difference(a, b));
    };
    constexpr double kTime = 10.0;
    Ocean set(parameters);
    const std::vector<float> before = heights(set, kTime);
    const double waves = moved(before, heights(set, kTime + kFrame));
    set.set("wind_speed", "14");
    EXPECT_GT(moved(before, heights(set, kTime)), 0.3);
    Ocean live(parameters);
    live.perform(kTime, "wind_speed", "14");
    EXPECT_EQ(heights(live, kTime), before);
    EXPECT_LT(moved(before, heights(live, kTime + kFrame)), 2.0 * waves);
}

TEST(Perform, CostsTheNewTicksOfFoamAlone) {
    Ocean live(played_sea(), {.threads = 1});
    shown(live, 10.0);
    const auto ticks = [&] { return live.stage_runs().foam_ticks; };
    const auto first = ticks();
    EXPECT_GT(first, 100);
    live.perform(10.0, "wind_speed", "14");
    shown(live, 10.0);
    EXPECT_EQ(ticks() - first, 1);  // that of 10.0 s itself, from which on the sea is another
    shown(live, 10.21);
    EXPECT_EQ(ticks() - first, 5);
    // Each map has its own.
    shown(live, 10.21, 32);
    const auto both = ticks();
    for (int i = 1; i <= 4; ++i) {
        live.perform(10.21 + 0.05 * i, "wind_speed", std::to_string(14 - i));
        shown(live, 10.21 + 0.05 * i);
        shown(live, 10.21 + 0.05 * i, 32);
    }
    EXPECT_EQ(ticks() - both, 8);
}

TEST(Perform, ThinsAKnobThatNeverRestsAndKeepsItsLastValue) {
    Ocean live(played_sea());
    for (int i = 0; i <= 1000; ++i) {
        live.perform(5.0 + i * 1e-3, "wind_speed", std::to_string(5.0 + 0.01 * i));
        live.perform(5.0 + i * 1e-3, "choppiness", std::to_string(0.5 + 0.0005 * (i % 7)));
    }
    const auto& events = live.sea().take.events;
    EXPECT_LE(events.size(), 2u * 62u);
    EXPECT_GE(events.size(), 2u * 58u);
    for (std::size_t i = 1; i < events.size(); ++i) {
        EXPECT_LE(events[i - 1].seconds, events[i].seconds);
    }
    EXPECT_LE(events.back().seconds, 6.0 + kMinEventSpacing);
    EXPECT_EQ(live.sea().at(100.0).waves.front().wind_speed, 15.0);
    EXPECT_EQ(live.sea().at(100.0).surface.choppiness, 0.5 + 0.0005 * (1000 % 7));
    validate(live.sea());
    // A value that the parameter already has adds no event.
    live.perform(10.0, "wind_speed", "15");
    EXPECT_EQ(live.sea().take.events.size(), events.size());
    EXPECT_LE(live.sea().take.events.back().seconds, 6.1);
}

TEST(Perform, RefusesWhatATakeCannotHoldAndChangesNothing) {
    Ocean live(played_sea());
    live.perform(5.0, "wind_speed", "12");
    EXPECT_TRUE(test::says(refusal(live, 6.0, "grid.resolution", "128"), "is not live"));
    EXPECT_TRUE(test::says(refusal(live, 4.9, "wind_speed", "13"), "last performed event, at 5 s"));
    EXPECT_TRUE(test::says(refusal(live, 6.0, "wind_speed", "76"), "0 .. 75"));
    EXPECT_NE(refusal(live, 6.0, "wind_speed", ""), "");
    EXPECT_TRUE(test::says(refusal(live, 6.0, "peak_period", ""), "has no value"));
    EXPECT_NE(refusal(live, 6.0, "wind_sped", "3"), "");
    EXPECT_NE(refusal(live, 6.0, "waves.1.fetch", "3000"), "");
    EXPECT_TRUE(test::says(refusal(live, 1e39, "wind_speed", "13"), "-1e9 .. 1e9"));
    EXPECT_NE(refusal(live, std::nan(""), "wind_speed", "13"), "");
    EXPECT_EQ(live.sea().take.events.size(), 1u);
    live.perform(5.0, "fetch", "50000");  // the refused times do not count
    EXPECT_EQ(live.sea().take.events.size(), 2u);

    Parameters loop = played_sea();
    loop.time.loop_period = 10.0;
    Ocean repeats(loop);
    EXPECT_TRUE(test::says(refusal(repeats, 1.0, "wind_speed", "12"), "loop_period"));
    EXPECT_TRUE(repeats.sea().take.empty());
}

TEST(Perform, RefusesAnEventTooManyAndGoesOnShowing) {
    Ocean live(played_sea());
    for (std::size_t i = 0; i < kMaxTakeEvents; ++i) {
        live.perform(static_cast<double>(i) * kFrame * 1.001, "wind_speed",
                     i % 2 == 0 ? "9" : "11");
    }
    const double end = static_cast<double>(kMaxTakeEvents) * kFrame * 1.001;
    EXPECT_TRUE(test::says(refusal(live, end, "wind_speed", "12"), "the take is full"));
    EXPECT_EQ(live.sea().take.events.size(), kMaxTakeEvents);
    EXPECT_EQ(shown(live, end).size(), 2u * kMap * kMap);
}

}  // namespace
}  // namespace ocean
