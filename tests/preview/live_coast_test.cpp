// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A coast that is changed while it is shown: the one before stays until the new one is computed.
#include <chrono>
#include <thread>

#include "ocean-preview/live_sea.hpp"
#include "ocean-preview/workload.hpp"
#include "ocean/internal/gl/context.hpp"
#include "preview/beach_sea.hpp"
#include "refusal.hpp"
#include "testing.hpp"

namespace ocean::app {
namespace {

constexpr const char* kWindOfCoast = "waves.0.wind_speed";
constexpr std::array<double, 3> kEye = {205.0, 96.0, 2.0};

class LiveCoastTest : public ::testing::Test {
  protected:
    void TearDown() override {
        for (const std::string& message : context_.messages()) ADD_FAILURE() << message;
    }
    static LiveSeaOptions options() {
        return {.threads = 1, .computing = [](const Sea& sea) {
                    Computing computing = computing_for(Backend::cpu, {}, sea, gl::context_info());
                    computing.maps.coast.samples = 32;
                    return computing;
                }};
    }
    static double wind(const Parameters& parameters) {
        return parameters.waves.front().wind_speed.value();
    }
    /// Returns the heights of the finest window.
    static std::vector<float> heights(const preview::DrawnSea& sea) {
        std::vector<float> heights;
        const std::vector<float>& shape = sea.coast->windows.at(0).shape;
        for (std::size_t n = 2; n < shape.size(); n += 4) heights.push_back(shape[n]);
        return heights;
    }
    static std::vector<float> heights(Ocean& ocean, const preview::CoastWindow& window,
                                      double time) {
        const Surface region = ocean.region(time, window.domain(), Channel::height);
        const auto values = region.channel(Channel::height);
        return {values.begin(), values.end()};
    }
    static void wait_for_coast(LiveSea& live) {
        while (live.coast_in_work()) {
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
            live.advance(0.0);
        }
    }

  private:
    const gl::HeadlessContext context_{{.debug = true}};
    const gl::HeadlessContext::Current current_{context_};
};

TEST_F(LiveCoastTest, TheOpenSeaStandsForACoastThatIsInWork) {
    LiveSea live(test::beach_sea(), options());
    EXPECT_TRUE(live.coast_in_work());
    EXPECT_FALSE(live.can_query());
    EXPECT_NE(live.coast_progress().find("%"), std::string::npos);
    const preview::DrawnSea first = live.show(kEye);
    ASSERT_TRUE(first.coast);
    EXPECT_TRUE(first.coast->windows.empty());
    wait_for_coast(live);
    EXPECT_FALSE(live.fading());
    EXPECT_TRUE(live.can_query());
    EXPECT_EQ(live.show(kEye).coast->windows.size(), preview::kMaxWindows);
}

TEST_F(LiveCoastTest, TheCoastBeforeStaysUntilThatOfANewWindIsComputed) {
    LiveSea live(test::beach_sea(), options());
    live.settle();
    live.set(kWindOfCoast, "14");
    EXPECT_TRUE(live.coast_in_work());
    EXPECT_EQ(wind(live.now()), 14.0);  // as the panel shows it
    live.paused = true;
    Ocean before(test::beach_sea(), {.threads = 1});
    const preview::DrawnSea meanwhile = live.show(kEye);
    EXPECT_EQ(heights(meanwhile), heights(before, meanwhile.coast->windows[0].window, live.time()));
    wait_for_coast(live);
    ASSERT_TRUE(live.fading());
    live.advance(0.5);
    const std::vector<float> half = heights(live.show(kEye));
    live.advance(0.6);
    ASSERT_FALSE(live.fading());
    Sea stronger = test::beach_sea();
    stronger.parameters.waves.front().wind_speed = 14.0;
    Ocean after(stronger, {.threads = 1});
    const preview::DrawnSea shown = live.show(kEye);
    const std::vector<float> now = heights(shown);
    EXPECT_EQ(now, heights(after, shown.coast->windows[0].window, live.time()));
    // Half way it is the mean of both.
    const std::vector<float> then = heights(meanwhile);
    for (std::size_t n = 0; n < half.size(); n += 37) {
        EXPECT_NEAR(half[n], 0.5f * (then[n] + now[n]), 1e-4f);
    }
}

TEST_F(LiveCoastTest, AChangeMeanwhileStopsTheOneInWork) {
    LiveSea live(test::beach_sea(), options());
    live.settle();
    for (const char* speed : {"11", "12", "13"}) live.set(kWindOfCoast, speed);
    wait_for_coast(live);
    EXPECT_EQ(wind(live.ocean().parameters()), 13.0);
}

TEST_F(LiveCoastTest, ACoastThatCannotBeComputedLeavesTheOneBefore) {
    LiveSea live(test::beach_sea(), options());
    live.settle();
    EXPECT_THROW(live.set(kWindOfCoast, "-3"), Error);
    EXPECT_FALSE(live.coast_in_work());
    live.set(kWindOfCoast, "0");
    EXPECT_TRUE(test::says(test::message_of([&] { wait_for_coast(live); }), "no waves"));
    EXPECT_EQ(wind(live.sea().parameters), 9.0);
    EXPECT_FALSE(live.show(kEye).coast->windows.empty());
}

TEST_F(LiveCoastTest, NothingIsRecordedOverABed) {
    LiveSea live(test::beach_sea(), options());
    live.settle();
    EXPECT_THROW(live.start_recording(), Error);
    EXPECT_THROW(live.drive_new_hull(0.0, 0.0, 0.0), Error);
    EXPECT_TRUE(live.sea().parameters.hulls.empty());
}

}  // namespace
}  // namespace ocean::app
