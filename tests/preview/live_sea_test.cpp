// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A sea that is changed while it runs: what glides, what fades, what is kept, what is recorded.
#include "ocean-preview/live_sea.hpp"

#include "ocean-preview/panel/changes.hpp"
#include "ocean-preview/workload.hpp"
#include "ocean/internal/gl/context.hpp"
#include "ocean/seafile.hpp"
#include "preview/shown_maps.hpp"
#include "refusal.hpp"
#include "unit/test_seas.hpp"

namespace ocean::app {
namespace {

class LiveSeaTest : public ::testing::Test {
  protected:
    void TearDown() override {
        for (const std::string& message : context_.messages()) ADD_FAILURE() << message;
    }
    static LiveSeaOptions options(const Backend& backend = Backend::cpu) {
        return {.threads = 1, .computing = [backend](const Sea& sea) {
                    return computing_for(backend, {}, sea, gl::context_info());
                }};
    }
    static Sea windy_sea(int resolution = 32) {
        Parameters parameters = test::wind_sea(resolution, 200.0);
        parameters.waves.front().wind_speed = 15.0;
        return {parameters, {}};
    }
    static double wind(const Parameters& parameters) {
        return parameters.waves.front().wind_speed.value();
    }

  private:
    const gl::HeadlessContext context_{{.debug = true}};
    const gl::HeadlessContext::Current current_{context_};
};

constexpr const char* kWind = "waves.0.wind_speed";

TEST_F(LiveSeaTest, WhatIsNotRecordedGlidesAndIsKeptAsAValue) {
    LiveSea live(windy_sea(), options());
    live.advance(1.0);
    live.set(kWind, "20");
    EXPECT_EQ(wind(live.now()), 15.0);  // it begins to glide
    live.advance(0.5);
    EXPECT_GT(wind(live.now()), 16.0);
    EXPECT_LT(wind(live.now()), 20.0);
    EXPECT_EQ(wind(live.sea().parameters), 20.0);
    EXPECT_TRUE(live.sea().take.empty());
    EXPECT_FALSE(live.fading());
    // Back in time it holds from the start.
    live.go_to(0.2);
    EXPECT_EQ(wind(live.now()), 20.0);
}

TEST_F(LiveSeaTest, WhatIsRecordedIsATakeOnTopOfIt) {
    LiveSea live(windy_sea(), options());
    live.set(kWind, "12");
    live.advance(3.0);
    live.start_recording();
    EXPECT_EQ(wind(live.now()), 12.0);
    live.set("surface.choppiness", "0.5");
    live.advance(1.0);
    live.set(kWind, "18");
    live.advance(1.0);
    live.stop_recording();
    ASSERT_EQ(live.sea().take.events.size(), 2u);
    EXPECT_EQ(live.sea().take.events[0].seconds, 3.0);
    EXPECT_EQ(live.sea().take.events[1].seconds, 4.0);
    EXPECT_EQ(wind(live.sea().parameters), 12.0);
    EXPECT_EQ(live.take_end(), 4.0);
    // A parameter that the take plays has no other value; the others are free.
    EXPECT_THROW(live.set(kWind, "9"), Error);
    EXPECT_EQ(wind(live.sea().parameters), 12.0);
    live.set("waves.0.wind_direction", "45");
    EXPECT_EQ(live.sea().take.events.size(), 2u);
    // It plays, also while something else is changed in its middle.
    live.go_to(3.5);
    live.set("waves.0.wind_direction", "60");
    EXPECT_EQ(wind(live.now()), 12.0);
    live.go_to(30.0);
    EXPECT_EQ(wind(live.now()), 18.0);
}

TEST_F(LiveSeaTest, RecordingAnewDropsWhatTheTakeHasLater) {
    LiveSea live(windy_sea(), options());
    live.start_recording();
    for (const char* speed : {"11", "12", "13"}) {
        live.set(kWind, speed);
        live.advance(1.0);
    }
    live.go_to(1.5);  // which ends it
    EXPECT_FALSE(live.recording());
    EXPECT_EQ(live.sea().take.events.size(), 3u);
    live.start_recording();
    EXPECT_EQ(live.sea().take.events.size(), 2u);
    live.set(kWind, "6");
    EXPECT_EQ(live.sea().take.events.back().seconds, 1.5);
    // Another sea of the same take: applied, not recorded.
    live.set("random.seed", "9");
    EXPECT_TRUE(live.fading());
    EXPECT_TRUE(live.recording());
    EXPECT_EQ(live.sea().take.events.size(), 3u);
    EXPECT_EQ(live.sea().parameters.seed, 9u);
}

TEST_F(LiveSeaTest, ItPlaysAgainFromItsStart) {
    LiveSea live(windy_sea(), options());
    live.play_again_after = 5.0;
    for (int i = 0; i < 23; ++i) live.advance(1.0);
    EXPECT_NEAR(live.time(), 3.0, 1e-9);
    live.start_recording();
    live.advance(4.0);
    EXPECT_NEAR(live.time(), 7.0, 1e-9);  // what is recorded goes forward
    EXPECT_TRUE(live.recording());
}

TEST_F(LiveSeaTest, ALoopRefusesToRecordAndSaysWhy) {
    Sea loop = windy_sea();
    loop.parameters.time.loop_period = 20.0;
    LiveSea live(loop, options());
    EXPECT_TRUE(test::says(test::message_of([&] { live.start_recording(); }), "loop_period = 20"));
    EXPECT_FALSE(live.recording());
    // Its live parameters are changed all the same, by fading.
    live.set(kWind, "10");
    EXPECT_TRUE(live.fading());
    EXPECT_EQ(wind(live.sea().parameters), 10.0);
    // A slider that is dragged does not wait for a fade to end.
    live.advance(0.1);
    live.set(kWind, "11");
    EXPECT_EQ(wind(live.now()), 11.0);
    EXPECT_EQ(wind(live.ocean().parameters()), 11.0);
}

TEST_F(LiveSeaTest, ASecondOtherSeaWaitsForTheFirst) {
    LiveSea live(windy_sea(), options());
    live.set("random.seed", "5");
    live.advance(0.4);
    live.set("random.seed", "6");
    EXPECT_EQ(live.sea().parameters.seed, 6u);
    EXPECT_EQ(live.now().seed, 6u);
    EXPECT_EQ(live.ocean().parameters().seed, 5u);  // a jump would be seen
    live.advance(0.7);
    EXPECT_TRUE(live.fading());
    EXPECT_EQ(live.ocean().parameters().seed, 6u);
    live.advance(1.1);
    EXPECT_FALSE(live.fading());
}

TEST_F(LiveSeaTest, WhatIsRefusedChangesNothing) {
    LiveSea live(windy_sea(), options());
    const std::string before = write_sea(live.sea());
    EXPECT_THROW(live.set(kWind, "-3"), Error);
    EXPECT_THROW(live.set("random.seed", "many"), Error);
    EXPECT_THROW(live.set("grid.resolution", "33"), Error);
    EXPECT_THROW(live.set("nothing", "1"), Error);
    EXPECT_EQ(write_sea(live.sea()), before);
    EXPECT_FALSE(live.fading());
    live.show();
    // A file that is not there, or not there any more, matters when it is asked for.
    live.set("waves.0.file", "/there/is/none.txt");
    const std::string named = write_sea(live.sea());
    EXPECT_THROW(live.set("waves.0.spectrum", "measured"), Error);
    EXPECT_EQ(write_sea(live.sea()), named);
    live.show();
}

TEST_F(LiveSeaTest, HoursOfAKnobThatNeverRestsDoNotFillTheTake) {
    LiveSea live(windy_sea(), options());
    for (int i = 0; i < 9000; ++i) {
        live.advance(1.0 / 60.0);
        live.set("surface.choppiness", i % 2 == 0 ? "0.9" : "0.8");
    }
    EXPECT_TRUE(live.sea().take.empty());
    EXPECT_LE(live.ocean().sea().take.events.size(), 2001u);
}

/// Advances in frames.
void run(LiveSea& live, double seconds) {
    for (int frame = 0; frame < 24.0 * seconds; ++frame) live.advance(1.0 / 24.0);
}

TEST_F(LiveSeaTest, ADrivenHullWritesItsTrackIntoTheSea) {
    LiveSea live(windy_sea(), options());
    live.set("waves.0.wind_speed", "12");  // glides, which is no reason to forget the foam
    live.drive_new_hull(10.0, 20.0, 90.0);
    ASSERT_NE(live.drive(), nullptr);
    live.drive()->want({90.0, 6.0});
    run(live, 8.0);
    live.show();
    // A parameter that makes another sea, also of the hull, leaves it its way.
    live.set("hulls.0.beam", "5");
    run(live, 2.0);
    ASSERT_NE(live.drive(), nullptr);
    live.stop_drive();
    const Hull& hull = live.sea().parameters.hulls.at(0);
    EXPECT_EQ(hull.beam, 5.0);
    EXPECT_NEAR(hull.track->rows.back().time, 10.0, 0.3);
    EXPECT_NEAR(hull.track->rows.back().x, 10.0, 1e-6);
    EXPECT_NEAR(hull.track->rows.back().y, 20.0 + 0.5 * 6.0 * 6.0 + 4.0 * 6.0, 2.0);
    EXPECT_EQ(hull.track, live.ocean().parameters().hulls.at(0).track);
    // Another drive goes on with it, also while something is recorded.
    const std::size_t rows = hull.track->rows.size();
    live.start_recording();
    live.start_drive(0);
    run(live, 3.0);
    live.set("surface.choppiness", "0.5");
    run(live, 1.0);
    live.stop_recording();
    live.go_to(2.0);  // which ends it
    EXPECT_EQ(live.drive(), nullptr);
    EXPECT_GT(live.sea().parameters.hulls.at(0).track->rows.size(), rows);
    EXPECT_EQ(live.sea().take.events.size(), 1u);
    EXPECT_TRUE(test::says(write_sea(live.sea()), "track = ["));
}

TEST_F(LiveSeaTest, ACrestIsPlacedAheadOfTheClockOrRefusedWithItsSentence) {
    LiveSea live(windy_sea(), options());
    live.go_to(3.0);
    PanelState state;
    add_crest(live, state, {40.0, 50.0});
    const auto& crests = live.sea().parameters.crests;
    ASSERT_EQ(crests.size(), 1u);
    EXPECT_EQ(crests[0].time, 8.0);
    EXPECT_EQ(crests[0].x, 40.0);
    EXPECT_EQ(to_text(crests[0].height), "1.3 Hs");
    EXPECT_EQ(live.time(), 3.0);
    EXPECT_TRUE(live.fading());
    const WorldPoint place{40.0, 50.0};
    QuerySample water{};
    live.ocean().query(8.0, {&place, 1}, {&water, 1}, {.foam = false});
    const double height = live.ocean().state().significant_wave_height.resolved;
    EXPECT_GT(water.height, height);
    // Too high, no height, and one more at the same place and time.
    for (const auto& [typed, words] :
         std::map<std::string, std::string>{{"2.5 Hs", "allowed: -2 Hs .. 2 Hs"},
                                            {"high", "crests.1.height"},
                                            {"1 Hs", "lies at the place and time of crests.0"}}) {
        state.crest.height = typed;
        const auto add = [&] { add_crest(live, state, {40.0, 50.0}); };
        EXPECT_TRUE(test::says(test::message_of(add), words)) << typed;
    }
    EXPECT_EQ(live.sea().parameters.crests.size(), 1u);
    EXPECT_EQ(state.changes.size(), 1u);
    // Its sea plays no take: parameters fade, and nothing is recorded.
    live.set(kWind, "10");
    EXPECT_EQ(wind(live.sea().parameters), 10.0);
    EXPECT_TRUE(test::says(test::message_of([&] { live.start_recording(); }), "plays no take"));
    LiveSea performed(windy_sea(), options());
    performed.start_recording();
    performed.set(kWind, "10");
    performed.stop_recording();
    state.crest.height = "1 Hs";
    const auto add = [&] { add_crest(performed, state, {0.0, 0.0}); };
    EXPECT_TRUE(test::says(test::message_of(add), "plays no take"));
}

TEST_F(LiveSeaTest, WhereNoHullCanBeDrivenItSaysWhy) {
    LiveSea none(windy_sea(), options());
    EXPECT_EQ(test::message_of([&] { none.start_drive(0); }),
              "hulls.0: the sea has no such hull to drive; allowed: none");
    Sea loop = windy_sea();
    loop.parameters.time.loop_period = 20.0;
    LiveSea repeats(loop, options());
    EXPECT_TRUE(test::says(test::message_of([&] { repeats.drive_new_hull(0.0, 0.0, 0.0); }),
                           "a driven hull does"));
    EXPECT_TRUE(repeats.sea().parameters.hulls.empty());
    Sea second = windy_sea();
    second.parameters.surface.second_order = true;
    LiveSea sharper(second, options());
    sharper.drive_new_hull(0.0, 0.0, 0.0);
    EXPECT_NE(sharper.drive(), nullptr) << "wakes stand beside its waves";
    // A hull whose track is taken from it is driven no more.
    none.drive_new_hull(0.0, 0.0, 0.0);
    none.open(windy_sea());
    run(none, 1.0);
    EXPECT_EQ(none.drive(), nullptr);
}

TEST_F(LiveSeaTest, EveryBackendShowsTheSameSea) {
    LiveSea live(windy_sea(64), options());
    live.go_to(7.0);
    const std::vector<float> expected = test::shown_heights(live.show(), 64);
    for (const Backend& backend : preview_backends()) {
        LiveSea other(windy_sea(64), options(backend));
        other.go_to(7.0);
        const std::vector<float> found = test::shown_heights(other.show(), 64);
        ASSERT_EQ(found.size(), expected.size());
        double largest = 0.0;
        for (std::size_t i = 0; i < found.size(); ++i) {
            largest = std::max(largest, std::abs(static_cast<double>(found[i] - expected[i])));
        }
        EXPECT_LT(largest, 1e-5 * live.ocean().state().significant_wave_height.asked)
            << backend.name;
    }
}

TEST_F(LiveSeaTest, BackendsAreExchangedWhileItRuns) {
    Backend chosen = Backend::cpu;
    LiveSea live(windy_sea(64), {.threads = 1, .computing = [&](const Sea& sea) {
                                     return computing_for(chosen, {}, sea, gl::context_info());
                                 }});
    for (const Backend& backend : preview_backends()) {
        chosen = backend;
        live.compute_anew();
        EXPECT_EQ(live.computing().backend.name, backend.name);
        live.advance(0.1);
        live.show();
        live.set(kWind, backend == Backend::dft ? "9" : "10");
        live.show();
    }
    chosen = Backend::dft;
    live.compute_anew();
    EXPECT_THROW(live.set("grid.resolution", "128"), Error);
    EXPECT_EQ(live.sea().parameters.grid.resolution, 64);
}

}  // namespace
}  // namespace ocean::app
