// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The wake beside a hull is what a towing tank measured there.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "hulls/wake.hpp"
#include "ocean/thread_pool.hpp"

namespace ocean {
namespace {

struct Measured {
    double place;   // from the middle of the hull astern, in half lengths
    double height;  // times 2 g / U^2
};

/// The profile along the side of Wigley's parabolic model, L : B : T = 16 : 1.6 : 1, at the Froude
/// number 0.25 [ITTC 1983, tank of IHI].
constexpr Measured kProfile[] = {
    {-1.0, 0.177},  {-0.95, 0.378}, {-0.9, 0.374},  {-0.85, 0.281}, {-0.8, 0.151},
    {-0.7, -0.077}, {-0.6, -0.174}, {-0.5, -0.191}, {-0.4, -0.120}, {-0.3, -0.050},
    {-0.2, -0.016}, {-0.1, 0.022},  {0.0, 0.014},   {0.1, -0.027},  {0.2, -0.073},
    {0.3, -0.086},  {0.4, -0.080},  {0.5, -0.056},  {0.6, -0.046},  {0.7, -0.003},
    {0.8, 0.012},   {0.85, 0.013},  {0.9, 0.027},   {0.95, 0.070},  {1.0, 0.187}};

TEST(Wake, ProfileAlongAWigleyHullIsNearTheMeasuredOne) {
    constexpr double kLength = 100.0, kGravity = 9.81;
    const double speed = 0.25 * std::sqrt(kGravity * kLength);
    Hull hull;
    hull.length = kLength;
    hull.beam = kLength / 10.0;
    hull.draught = kLength / 16.0;
    hull.shape = HullShape::wigley;
    hull.wake_size = 6.0 * kLength;
    hull.wake_resolution = 512;
    auto track = std::make_shared<HullTrack>();
    track->rows = {{-1000.0, -1000.0 * speed, 0.0}, {1000.0, 1000.0 * speed, 0.0}};
    hull.track = track;
    Water water;
    water.gravity = kGravity;
    ThreadPool pool(1);
    Wake wake(hull, water, 0.0, pool);
    wake.move_to(0.0, false, pool);

    double error = 0.0;
    double energy = 0.0;
    Measured bow{}, measured_bow{};
    for (const Measured& there : kProfile) {
        // The centre plane stands for the side of a thin hull.
        const float z = wake.read(-0.5 * kLength * there.place, 0.0).height.value();
        const Measured ours{there.place, static_cast<double>(z) * 2.0 * kGravity / speed / speed};
        if (ours.height > bow.height) bow = ours;
        if (there.height > measured_bow.height) measured_bow = there;
        error += (ours.height - there.height) * (ours.height - there.height);
        energy += there.height * there.height;
    }
    // Thin-ship theory is off by this much: behind the middle its hollow is too deep, and it has no
    // rise at the stern.
    EXPECT_NEAR(bow.height / measured_bow.height, 1.0, 0.05);
    EXPECT_NEAR(bow.place, measured_bow.place, 0.06);
    EXPECT_LT(std::sqrt(error / energy), 0.45);
    RecordProperty("bow", std::to_string(bow.height));
    RecordProperty("error", std::to_string(std::sqrt(error / energy)));
}

}  // namespace
}  // namespace ocean
