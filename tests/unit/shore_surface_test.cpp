// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The surface of a sea over its bed: equal to the open sea where no wave feels the bed, limited and
// without folds where waves break, with normals and velocities that are its own derivatives.

#include "ocean/internal/gauge_series.hpp"
#include "ocean/internal/open_sea.hpp"
#include "ocean/land_mask.hpp"
#include "refusal.hpp"
#include "test_beds.hpp"
#include "test_seas.hpp"

namespace ocean {
namespace {

/// A beach that rises 1 in `run` to the east from 20 m of depth; still water ends at x = 800 m.
Parameters beach_sea(double run = 40.0) {
    return test::over(test::coast_sea(256, 1024.0, 20.0),
                      test::bed_of(257, 129, 4.0, [run](double x, double) {
                          return std::max(-20.0, (x - 800.0) / run);
                      }));
}

Domain square(double x, double y, int samples, double cell) {
    return {{x, y}, {(samples - 1) * cell, (samples - 1) * cell}, {samples, samples}, false};
}

TEST(ShoreSurface, RegionsHaveTheSameBitsForAnyNumberOfThreads) {
    const Domain domain = square(600.0, 200.0, 32, 6.0);
    const ChannelSet channels = {Channel::height, Channel::nx, Channel::vz, Channel::foam};
    Ocean one(beach_sea(), {.threads = 1});
    Ocean three(beach_sea(), {.threads = 3});
    EXPECT_TRUE(
        test::same_bits(one.region(11.0, domain, channels), three.region(11.0, domain, channels)));
}

TEST(ShoreSurface, NoWaveFoldsOrExceedsWhatItsDepthCarriesAndTheBorderIsNoSeam) {
    Ocean ocean(beach_sea());
    const Domain domain = square(500.0, 60.0, 151, 2.0);
    for (const double time : {3.0, 40.0}) {
        const Surface map = ocean.region(
            time, domain, {Channel::height, Channel::jacobian, channel_of(LandMask::depth)});
        EXPECT_GT(*std::ranges::min_element(map.channel(Channel::jacobian)), 0.15f);
        for (const auto [i, j, at] : test::cells(151, 151)) {
            const double depth = std::max(0.6, (300.0 - 2.0 * i) / 40.0);
            // Short waves that are in no band add a little to the limited ones.
            EXPECT_LE(double{map.channel(Channel::height)[at]}, 1.05 * depth + 0.1);
        }
    }
    // Across the southern border, over 2 to 8 m of water.
    const Domain across{{480.0, -100.0}, {240.0, 240.0}, {121, 121}, false};
    const auto height = test::values_of(ocean.region(30.0, across, Channel::height));
    double near = 0.0, far = 0.0;
    for (const auto [i, j] : test::pairs({0, 121}, {1, 120})) {
        const double y = across.place(0, j)[1];
        const auto n = static_cast<std::size_t>(121 * j + i);
        const double bend =
            std::abs(double{height[n + 121]} - 2.0 * double{height[n]} + double{height[n - 121]});
        double& most = y > -6.0 && y < 70.0 ? near : far;
        most = std::max(most, bend);
    }
    EXPECT_LE(near, 1.2 * far);
}

TEST(ShoreSurface, SteepBeachesEndTheDisplacementWithoutFolds) {
    Ocean ocean(beach_sea(8.0));
    for (const double time : {3.0, 40.0}) {
        const Surface map = ocean.region(time, square(700.0, 60.0, 81, 2.0), Channel::jacobian);
        EXPECT_GT(*std::ranges::min_element(map.channel(Channel::jacobian)), 0.15f);
    }
}

TEST(ShoreSurface, SlopesVelocitiesAndTheMotionOfTheWaterAreDerivativesOfTheSurface) {
    Ocean ocean(beach_sea());
    constexpr double kTime = 21.0, kStep = 0.25, kTick = 0.01;
    // The first six lie over 15 to 10 m of water.
    std::vector<WorldPoint> points;
    for (int n = 0; n < 6; ++n) points.push_back({200.0 + 37.0 * n, 130.0 + 9.0 * n});
    for (int n = 0; n < 24; ++n) points.push_back({560.0 + 9.7 * n, 120.0 + 11.3 * n});
    const auto read = [&](double time, Channel channel, double east = 0.0) {
        std::vector<double> values;
        for (const auto& [x, y] : points) {
            const Domain place{{x + east, y}, {8.0, 8.0}, {2, 2}, false};
            values.push_back(ocean.region(time, place, channel).channel(channel)[0]);
        }
        return values;
    };
    const auto slope_of = [](std::vector<double> after, const std::vector<double>& before,
                             double run) {
        for (std::size_t i = 0; i < after.size(); ++i) after[i] = (after[i] - before[i]) / run;
        return after;
    };
    const auto before = read(kTime - kTick, Channel::height);
    const auto slopes = read(kTime, Channel::slope_x), rates = read(kTime, Channel::vz);
    const auto by_x = slope_of(read(kTime, Channel::height, kStep),
                               read(kTime, Channel::height, -kStep), 2.0 * kStep);
    std::vector<double> speeds;
    for (const auto& [x, y] : points) {
        const WaterPoint place{x, y, 0.0};
        WaterMotion motion;
        ocean.water_motion(kTime, {&place, 1}, {&motion, 1});
        speeds.push_back(motion.velocity_z);
    }
    const WaterPoint in_the_bed{600.0, 200.0, -6.0};
    WaterMotion still{1.0, 1.0, 1.0, 1.0};
    ocean.water_motion(kTime, {&in_the_bed, 1}, {&still, 1});
    EXPECT_EQ(still, WaterMotion{});
    const auto by_time = slope_of(read(kTime + kTick, Channel::height), before, 2.0 * kTick);
    const auto error = [&](const std::vector<double>& a, const std::vector<double>& b,
                           std::size_t first, std::size_t count) {
        return test::rms(test::difference(std::span(a).subspan(first, count),
                                          std::span(b).subspan(first, count))) /
               test::rms(std::span(b).subspan(first, count));
    };
    EXPECT_LE(error(by_x, slopes, 6, 24), 0.01);
    EXPECT_LE(error(by_time, rates, 6, 24), 1e-3);
    // Linear theory lacks the crest shape's share.
    EXPECT_LE(error(speeds, by_time, 0, 6), 0.05);
}

TEST(ShoreSurface, QueriesAndGaugesFindTheSurfaceThatRegionsShow) {
    Ocean ocean(beach_sea());
    const Domain domain = square(560.0, 100.0, 24, 9.0);
    const Surface map = ocean.region(9.0, domain, {Channel::dx, Channel::dy, Channel::height});
    std::vector<WorldPoint> points;
    for (const auto [i, j, at] : test::cells(24, 24)) {
        const auto [x, y] = domain.place(i, j);
        points.push_back(
            {x + double{map.channel(Channel::dx)[at]}, y + double{map.channel(Channel::dy)[at]}});
    }
    const auto samples = test::query(ocean, 9.0, points, {.foam = false});
    for (std::size_t i = 0; i < points.size(); ++i) {
        EXPECT_FALSE(samples[i].undecided);
        EXPECT_NEAR(samples[i].height, double{map.channel(Channel::height)[i]}, 3e-5);
    }
    Gauge gauge{"surf", {{0.0, {640.0, 150.0, -1.0}}}};
    const GaugeSeries series =
        read_gauge_series(ocean, {gauge}, {5.0, 6.0, 2.0}, test::pool(), [](std::size_t) {});
    ASSERT_EQ(series.times, 3u);
    const WorldPoint point{640.0, 150.0};
    const auto exact = test::query(ocean, 5.5, {&point, 1}, {.exact = true, .foam = false});
    EXPECT_EQ(series.reading(1, 0)[GaugeSeries::kElevation], exact[0].height);
}

// Exact queries sum modes where the others interpolate: from beyond the border to the run-up the
// two differ by the error of the interpolation, which is 2e-6 of the waves, and no more than that
// by rounding. Motions sum too; without that they lack the error of OrbitalMotion, which at this
// resolution is up to 3e-3 of the waves' speed.
TEST(ShoreSurface, ExactQueriesDifferFromOthersByTheInterpolationAlone) {
    Ocean ocean(beach_sea());
    std::vector<WorldPoint> points;
    std::vector<WaterPoint> depths;
    for (int i = 0; i < 24; ++i) {
        points.push_back({-60.0 + 36.6 * i, 10.0 + 10.2 * i});
        depths.push_back({points.back().x, points.back().y, -1.0});
    }
    std::vector<WaterMotion> exact(points.size()), motions(points.size());
    const auto sums = test::query(ocean, 9.0, points, {.exact = true, .foam = false});
    const auto reads = test::query(ocean, 9.0, points, {.foam = false});
    ocean.water_motion(9.0, depths, exact, {.exact = true});
    ocean.water_motion(9.0, depths, motions);
    double error = 0.0, motion_error = 0.0, speed = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        error += std::pow(sums[i].height - reads[i].height, 2.0);
        motion_error += std::pow(exact[i].velocity_x - motions[i].velocity_x, 2.0);
        speed += std::pow(exact[i].velocity_x, 2.0);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            EXPECT_NEAR(sums[i].velocity[axis], reads[i].velocity[axis], 1e-4);
            EXPECT_NEAR(sums[i].normal[axis], reads[i].normal[axis], 1e-4);
        }
    }
    const double height = ocean.state().significant_wave_height.asked;
    error = std::sqrt(error / static_cast<double>(points.size()));
    EXPECT_LE(error, 2e-6 * height);
    EXPECT_GT(error, 2e-8 * height) << "both interpolate";
    EXPECT_LE(std::sqrt(motion_error / speed), 3e-3);
    EXPECT_GT(motion_error, 0.0);
    EXPECT_LT(ocean.query_height_error(9.0, {.exact = true}), ocean.query_height_error(9.0));
    // A sea at another time does not disturb them, nor do threads.
    Ocean alone(ocean, {.threads = 3});
    test::query(alone, 8.0, points, {.foam = false});
    const auto again = test::query(alone, 9.0, points, {.exact = true, .foam = false});
    for (std::size_t i = 0; i < points.size(); ++i) EXPECT_EQ(sums[i].height, again[i].height);
}

TEST(ShoreSurface, SeaAroundACoastIsTheSeaWithoutABedAndHasItsModesOnce) {
    Parameters parameters = beach_sea();
    Ocean coast(parameters);
    parameters.water.bed = nullptr;
    Ocean sea(parameters);
    constexpr ChannelSet kMaps = {Channel::dx, Channel::height, Channel::foam};
    coast.region(2.0, square(700.0, 100.0, 8, 4.0), Channel::height);
    EXPECT_TRUE(
        test::same_bits(coast.open_sea().evaluate(2.0, kMaps, 256), sea.evaluate(2.0, kMaps, 256)));
    EXPECT_EQ(coast.stage_runs().modes, 1);
    EXPECT_EQ(coast.stage_runs().spectrum, 1);
}

TEST(ShoreSurface, SeaAroundACoastGoesOnWithTheFoamOfAnObjectOfTheSameWaves) {
    const OceanOptions options{.foam_start = FoamStart::empty};
    const auto foam_at = [](Ocean& ocean, double time) {
        return test::values_of(ocean.open_sea().evaluate(time, Channel::foam, 256), Channel::foam);
    };
    Ocean before(beach_sea(), options);
    for (const double time : {0.0, 1.0, 2.0}) foam_at(before, time);
    Ocean next(before, options), anew(before, options);
    next.open_sea().take_foam(before.open_sea());
    const std::vector<float> taken = foam_at(next, 3.0);
    EXPECT_NE(taken, foam_at(anew, 3.0));

    Ocean whole(beach_sea(), options);
    for (const double time : {0.0, 1.0, 2.0}) foam_at(whole, time);
    EXPECT_EQ(taken, foam_at(whole, 3.0));

    Ocean other(before, options);
    other.set("waves.0.wind_speed", "9");
    other.open_sea().take_foam(next.open_sea());
    Ocean fresh(other, options);
    EXPECT_EQ(foam_at(other, 3.0), foam_at(fresh, 3.0));
}

TEST(ShoreSurface, WhatDoesNotKnowTheBedIsRefused) {
    Ocean ocean(beach_sea());
    const auto refuses = [](const char* sentence, auto&& call) {
        const test::Refusal refusal = test::refusal_of(call);
        EXPECT_EQ(refusal.kind, ErrorKind::unsupported) << sentence;
        EXPECT_TRUE(test::says(refusal.message, sentence));
    };
    std::vector<float> map(256 * 256);
    const std::vector<MapOutput> height = {{map.data(), 1, {{{Channel::height}}}}};
    const std::vector<MapOutput> linear = {{map.data(), 1, {{{Linear::height}}}}};
    refuses("a map of one period", [&] { ocean.evaluate(0.0, Channel::height); });
    refuses("a map of one period", [&] { ocean.evaluate_into(0.0, height, 256); });
    refuses("a map of a cascade", [&] { ocean.evaluate_cascade_into(0, 0.0, height, 256); });
    refuses("a slope tile", [&] { ocean.detail_budget(0.0); });
    refuses("no linear fields", [&] { ocean.region_into(0.0, square(500, 100, 8, 1.0), linear); });
    refuses("plays no take", [&] { ocean.perform(1.0, "wind_speed", "12"); });
    const WorldPoint point{500.0, 100.0};
    const WaterPoint depth{500.0, 100.0, -1.0};
    QuerySample sample;
    WaterMotion motion;
    refuses("resolution = 64: over a bed", [&] {
        ocean.query(0.0, {&point, 1}, {&sample, 1}, {.foam = false, .resolution = 64});
    });
    refuses("resolution = 64: over a bed", [&] {
        ocean.water_motion(0.0, {&depth, 1}, {&motion, 1}, {.resolution = 64});
    });
    EXPECT_NO_THROW(
        ocean.query(0.0, {&point, 1}, {&sample, 1}, {.foam = false, .resolution = 256}));
    Ocean open(test::coast_sea(256, 1024.0, 20.0));
    refuses("has no bed", [&] { open.region(0.0, square(0, 0, 8, 1.0), Channel::height); });
    refuses("has no bed", [&] { open.prepare_coast(); });
}

}  // namespace
}  // namespace ocean
