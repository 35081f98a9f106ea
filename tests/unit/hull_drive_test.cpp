// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A driven hull goes on from its track, obeys within what a track may have, and its past stays.
#include "ocean/internal/hull_drive.hpp"

#include "hulls/track_path.hpp"
#include "hulls/wake.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/hull_rules.hpp"
#include "ocean/ocean.hpp"
#include "test_seas.hpp"

namespace ocean {
namespace {

Hull boat(std::shared_ptr<const HullTrack> track) {
    Hull hull;
    hull.length = 12.0;
    hull.beam = 3.0;
    hull.draught = 0.8;
    hull.wake_resolution = 64;
    hull.track = std::move(track);
    return hull;
}

/// A bend without courses.
Hull bending_boat() {
    auto track = std::make_shared<HullTrack>();
    track->rows = {{0.0, 0.0, 0.0}, {10.0, 50.0, 0.0}, {20.0, 90.0, 30.0}, {30.0, 100.0, 80.0}};
    return boat(track);
}

/// At rest at the origin, heading north-east.
Hull resting_boat(double time = 0.0) {
    auto track = std::make_shared<HullTrack>();
    track->rows = {{time, 0.0, 0.0}};
    track->courses = {{45.0, 0.0}};
    return boat(track);
}

TEST(HullDrive, GoesOnFromItsTrackWithoutAJump) {
    const Hull hull = bending_boat();
    const TrackPath before(hull.track, 0.0);
    for (const double from : {10.02, 16.3, 25.0, 30.1}) {
        HullDrive drive(hull, from);
        drive.advance(from + 5.0);
        require_track(*drive.driven(), "track");
        const TrackPath after(drive.driven(), 0.0);
        for (double t = -1.0; t < std::min(from, 30.0); t += 0.7) {
            EXPECT_NEAR(after.place(t).x, before.place(t).x, 1e-9) << t;
            EXPECT_NEAR(after.place(t).y, before.place(t).y, 1e-9) << t;
        }
        // The cubic of a bend overshoots a little as it straightens.
        for (double t = from - 1.0; t < from + 4.0; t += 0.1) {
            const PathVector a = after.velocity(t), b = after.velocity(t + 0.1);
            EXPECT_LT(std::hypot(b.x - a.x, b.y - a.y), 0.5) << from << " " << t;
        }
    }
    // Long after its end it starts from rest there, and before its begin at its first place.
    HullDrive late(hull, 50.0), early(hull, -5.0);
    late.advance(55.0);
    EXPECT_EQ(late.pose(55.0).x, 100.0);
    EXPECT_EQ(TrackPath(late.driven(), 0.0).place(40.0).y, 80.0);
    early.want({0.0, 3.0});
    early.advance(-2.0);
    EXPECT_EQ(early.driven()->rows.front().time, -5.0);
    EXPECT_NEAR(early.pose(-2.0).x, 0.5 * 3.0 * 3.0, 0.1);
}

TEST(HullDrive, TakesUpWhatIsWantedWithinTheLimitsOfATrack) {
    HullDrive drive(resting_boat(), 0.1);
    drive.advance(2.0);
    EXPECT_EQ(drive.pose(2.0).x, 0.0);  // it cannot turn or move without speed
    drive.want({-90.0, 6.0});
    drive.advance(30.0);
    EXPECT_NEAR(drive.pose(30.0).course.speed, 6.0, 1e-9);
    EXPECT_NEAR(drive.pose(30.0).course.heading, -90.0, 1e-9);
    // Any jump of what is wanted, held for long.
    for (int i = 0; i < 60; ++i) {
        drive.want({137.0 * i, i % 3 == 0 ? 1e9 : 5.0});
        drive.advance(30.0 + 3.0 * i);
        drive.steer(1.0, i % 2 == 0 ? 1.0 : -50.0, 0.5);
        drive.advance(31.5 + 3.0 * i);
    }
    require_track(*drive.driven(), "track");
    require_track(*drive.planned(), "track");
    EXPECT_LE(drive.wanted().speed, kMaxHullSpeed);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const TrackCourse before = drive.wanted();
    for (const TrackCourse& bad : {TrackCourse{nan, 1.0}, TrackCourse{0.0, nan},
                                   TrackCourse{std::numeric_limits<double>::infinity(), 1.0}}) {
        EXPECT_THROW(drive.want(bad), Error);
    }
    EXPECT_EQ(drive.wanted(), before);
    EXPECT_THROW(HullDrive(resting_boat(), nan), Error);
}

TEST(HullDrive, ARudderThatComesBackHoldsTheHeading) {
    HullDrive drive(resting_boat(), 0.0);
    drive.want({45.0, 6.0});
    drive.advance(10.0);
    drive.steer(0.0, 1.0, 0.1);
    drive.advance(12.0);
    const double turned = drive.pose(12.0).course.heading;
    EXPECT_GT(turned, 60.0);
    drive.steer(0.0, 0.0, 0.1);
    drive.advance(20.0);
    EXPECT_NEAR(drive.pose(20.0).course.heading, turned, 0.06);
}

/// The waves that a drive has shown are those of its finished track: in a turn, at rest, after a
/// change of speed.
TEST(HullDrive, TheWakeOfAGrowingTrackIsThatOfTheWholeTrack) {
    ThreadPool& pool = test::pool();
    const Water water;
    HullDrive drive(hull_to_drive(resting_boat(), water), 0.0);
    Hull hull = hull_to_drive(resting_boat(), water);
    hull.track = drive.planned();
    Wake live(hull, water, 0.0, pool);
    const auto height = [](const Wake& wake) {
        const auto [x, y] = wake.past().place.centre;
        return wake.read(x + 9.0, y + 6.0).height.value();
    };
    drive.want({45.0, 7.0});
    double highest = 0.0;
    for (int frame = 1; frame <= 30 * 24; ++frame) {
        const double time = frame / 24.0;
        if (frame == 10 * 24) drive.steer(0.0, 0.7, 0.1);
        if (drive.advance(time)) {
            hull.track = drive.planned();
            ASSERT_TRUE(live.follow(hull, water)) << time;
        }
        live.move_to(time, false, pool);
        if (frame % 97 != 0) continue;
        Wake alone(hull, water, 0.0, pool);
        alone.move_to(time, false, pool);
        EXPECT_EQ(height(live), height(alone)) << time;
        highest = std::max(highest, std::abs(static_cast<double>(height(live))));
    }
    EXPECT_GT(highest, 0.02);
    // The saved track lacks the plan, by which alone its frame differs.
    const float shown = height(live);
    hull.track = drive.driven();
    Wake saved(hull, water, 0.0, pool);
    saved.move_to(30.0, false, pool);
    EXPECT_NEAR(height(saved), shown, 0.02 * highest);
    // Another hull's speed calls for another square, unless the hull's keys give it.
    hull.wake_size = hull.wake_age = 0.0;
    EXPECT_FALSE(live.follow(hull, water));
}

TEST(HullDrive, ATrackThatGrowsLeavesTheOpenSeaAsItIs) {
    Parameters parameters = test::wind_sea(32, 200.0);
    parameters.surface.foam_coverage = FoamCoverage::threshold;
    parameters.surface.foam_lifetime = 0.2;
    parameters.hulls = {hull_to_drive(resting_boat(), parameters.water)};
    HullDrive drive(parameters.hulls.front(), 0.0);
    parameters.hulls.front().track = drive.planned();
    Ocean ocean(parameters);
    ocean.perform(0.5, "wind_speed", "14");
    const Domain region{{-20.0, -20.0}, {40.0, 40.0}, {9, 9}, false};
    const auto show = [&](double time) {
        return ocean.region(time, region, {Channel::height, Channel::foam});
    };
    show(5.0);
    const int ticks = ocean.stage_runs().foam_ticks;
    drive.want({45.0, 7.0});
    drive.advance(5.5);
    Sea sea = ocean.sea();
    sea.parameters.hulls.front().track = drive.planned();
    ocean.change(sea);
    const Surface grown = show(5.1);
    EXPECT_LE(ocean.stage_runs().foam_ticks, ticks + 3);
    Ocean anew(sea);
    const Surface whole = anew.region(5.1, region, {Channel::height, Channel::foam});
    for (std::size_t i = 0; i < 81; ++i) {
        EXPECT_EQ(grown.channel(Channel::height)[i], whole.channel(Channel::height)[i]);
        EXPECT_EQ(grown.channel(Channel::foam)[i], whole.channel(Channel::foam)[i]);
    }
}

}  // namespace
}  // namespace ocean
