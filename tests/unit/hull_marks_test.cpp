// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The turbulent trail stays where the hull was and fades; the inside is the hull's water plane.
#include "hulls/hull_marks.hpp"
#include "testing.hpp"

namespace ocean {
namespace {

/// A hull of 20 m, at full white water from 5.6 m/s on.
Hull boat(std::vector<TrackRow> rows) {
    Hull hull;
    hull.length = 20.0;
    hull.beam = 4.0;
    hull.trail_lifetime = 10.0;
    auto track = std::make_shared<HullTrack>();
    track->rows = std::move(rows);
    hull.track = track;
    return hull;
}

/// East at 8 m/s through (0, 0) at time 0.
Hull straight_boat() {
    return boat({{-100.0, -800.0, 0.0}, {100.0, 800.0, 0.0}});
}

HullMarks marks_at(const Hull& hull, double time) {
    HullMarks marks(hull, 0.0);
    marks.move_to(time);
    return marks;
}

TEST(HullMarks, TheTrailFadesWithItsAge) {
    const HullMarks marks = marks_at(straight_boat(), 0.3);
    const double stern = 0.3 * 8.0 - 9.6;
    for (const double seconds : {0.0, 2.0, 10.0, 35.0}) {
        EXPECT_NEAR(marks.trail({stern - 8.0 * seconds, 0.0}), std::exp(-seconds / 10.0), 1e-6)
            << seconds;
    }
    EXPECT_LT(marks.trail({stern - 8.0 * 50.5, 0.0}), 1e-8f);  // five lifetimes
    EXPECT_EQ(marks.trail({stern + 3.0, 0.0}), 0.0f);          // below the hull
    Hull without = straight_boat();
    without.trail_lifetime = 0.0;
    EXPECT_EQ(marks_at(without, 0.3).trail({stern - 8.0, 0.0}), 0.0f);
}

TEST(HullMarks, TheTrailWidensAsTheFifthRootOfTheDistance) {
    const HullMarks marks = marks_at(straight_boat(), 0.0);
    const auto half_width = [&](double astern) {
        const float middle = marks.trail({-9.6 - astern, 0.0});
        double off = 0.0;
        while (marks.trail({-9.6 - astern, off}) > 0.5f * middle) off += 0.01;
        return off;
    };
    // Half the foam lies at 0.75 of the half width.
    EXPECT_NEAR(half_width(0.0), 0.75 * 0.7 * 2.0, 0.02);
    EXPECT_NEAR(half_width(80.0), 0.75 * 1.6 * 2.0 * std::pow(2.0, 0.2), 0.02);
    EXPECT_NEAR(half_width(240.0), 0.75 * 1.6 * 2.0 * std::pow(4.0, 0.2), 0.02);
}

TEST(HullMarks, TheTrailOfATurnStaysInItsPlace) {
    std::vector<TrackRow> rows;
    for (int i = -40; i <= 120; ++i) {
        const double t = 0.5 * i;
        rows.push_back({t, 40.0 * std::sin(0.2 * t), 40.0 * (1.0 - std::cos(0.2 * t))});
    }
    const Hull hull = boat(rows);
    // Along the stern's way; at its edges the trail grows as it widens.
    const auto brightest = [&](double time, double angle) {
        const HullMarks marks = marks_at(hull, time);
        float most = 0.0f;
        for (double r = 35.0; r < 50.0; r += 0.02) {
            most = std::max(most, marks.trail({r * std::sin(angle), 40.0 - r * std::cos(angle)}));
        }
        return static_cast<double>(most);
    };
    for (const double angle : {-1.5, -0.5, 0.0}) {
        const double was = brightest(3.0, angle);
        EXPECT_GT(was, 0.3);
        EXPECT_NEAR(brightest(4.25, angle) / was, std::exp(-0.125), 0.003);
    }
}

TEST(HullMarks, ASlowHullLeavesNoWhiteWater) {
    const HullMarks slow = marks_at(boat({{-100.0, -130.0, 0.0}, {100.0, 130.0, 0.0}}), 0.0);
    const HullMarks middling = marks_at(boat({{-100.0, -350.0, 0.0}, {100.0, 350.0, 0.0}}), 0.0);
    EXPECT_EQ(slow.trail({-15.0, 0.0}), 0.0f);            // Fr 0.09
    EXPECT_NEAR(middling.trail({-9.6, 0.0}), 0.5, 0.01);  // Fr 0.25
}

TEST(HullMarks, TheInsideIsTheWaterPlane) {
    // North-east to (0, 0), slower and slower, and at rest from 0 s on with the same heading.
    std::vector<TrackRow> rows;
    for (int t = -10; t <= 2; ++t) {
        const double way = t < 0 ? -0.06 * t * t * 10.0 : 0.0;
        rows.push_back({static_cast<double>(t), way, way});
    }
    rows.push_back({50.0, 0.0, 0.0});
    const Hull hull = boat(rows);
    const HullMarks marks = marks_at(hull, 20.0);
    double area = 0.0;
    constexpr double kStep = 0.05;
    for (double y = -12.0; y < 12.0; y += kStep) {
        for (double x = -12.0; x < 12.0; x += kStep) {
            area += static_cast<double>(marks.inside({x, y})) * kStep * kStep;
        }
    }
    EXPECT_NEAR(area, 2.0 / 3.0 * 20.0 * 4.0, 0.02 * area);
    const double half = std::sqrt(0.5);
    EXPECT_NEAR(marks.inside({-2.0 * half, 2.0 * half}), 0.5, 1e-3);
    EXPECT_EQ(marks.inside({9.0 * half, 9.0 * half}), 1.0f);
    EXPECT_EQ(marks.inside({9.0 * half, -9.0 * half}), 0.0f);
    // Before it moves it looks where it will go, and a row of a course has the last word.
    EXPECT_EQ(marks_at(hull, -30.0).inside({-60.0 + 9.0 * half, -60.0 + 9.0 * half}), 1.0f);
    Hull moored = boat({{0.0, 0.0, 0.0}, {10.0, 0.0, 0.0}});
    auto track = std::make_shared<HullTrack>(*moored.track);
    track->courses = {{90.0, 0.0}, {90.0, 0.0}};
    moored.track = track;
    EXPECT_EQ(marks_at(moored, 5.0).inside({0.0, 9.0}), 1.0f);
}

}  // namespace
}  // namespace ocean
