// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The surface of a sea over its bed: equal to the open sea where no wave feels the bed, limited and
// without folds where waves break, with normals and velocities that are its own derivatives.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "ocean/error.hpp"
#include "ocean/internal/gauge_series.hpp"
#include "ocean/internal/open_sea.hpp"
#include "ocean/land_mask.hpp"
#include "ocean/ocean.hpp"
#include "ocean/sea_bed.hpp"
#include "test_seas.hpp"

namespace ocean {
namespace {

/// JONSWAP, 12 m/s over 150 km: Hs 2.9 m, Tp 7.4 s.
Parameters surf_sea(double depth) {
    Parameters parameters;
    parameters.grid.resolution = 256;
    parameters.grid.patch_size = 1024.0;
    parameters.water.depth = depth;
    WaveSystem& waves = parameters.waves.front();
    waves.spectrum = SpectrumKind::jonswap;
    waves.wind_speed = 12.0;
    waves.fetch = 150000.0;
    return parameters;
}

/// Lays a bed of height(x, y) [m] below the sea, on cells of `cell` metres from (0, 0).
Parameters over(Parameters parameters, int columns, int rows, double cell,
                const std::function<double(double, double)>& height) {
    GivenBed given;
    given.grid = {{0.0, 0.0}, {(columns - 1) * cell, (rows - 1) * cell}, {columns, rows}, false};
    for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < columns; ++i) {
            given.heights.push_back(static_cast<float>(height(i * cell, j * cell)));
        }
    }
    parameters.water.bed = make_sea_bed(std::move(given), parameters.water);
    return parameters;
}

/// A beach that rises 1 in `run` to the east from 20 m of depth; still water ends at x = 800 m.
Parameters beach_sea(double run = 40.0) {
    return over(surf_sea(20.0), 257, 129, 4.0,
                [run](double x, double) { return std::max(-20.0, (x - 800.0) / run); });
}

Domain square(double x, double y, int samples, double cell) {
    return {{x, y}, {(samples - 1) * cell, (samples - 1) * cell}, {samples, samples}, false};
}

constexpr ChannelSet kPosition = {Channel::dx, Channel::dy, Channel::height};

class Deep : public testing::TestWithParam<double> {};

TEST_P(Deep, SeaOverABedAsDeepAsItselfIsTheOpenSea) {
    const double depth = GetParam();
    const double bed = std::isfinite(depth) ? -depth : -300.0;
    Parameters open = surf_sea(depth);
    const Parameters parameters = over(open, 129, 129, 4.0, [&](double, double) { return bed; });
    Ocean coast(parameters);
    Ocean sea(open);
    const double height = sea.state().significant_wave_height.resolved;
    const Surface whole = sea.evaluate(7.0, kPosition, 256);
    const Surface region = coast.region(7.0, square(0.0, 0.0, 128, 4.0), kPosition);
    for (const Channel channel : {Channel::height, Channel::dx, Channel::dy}) {
        double most = 0.0;
        for (int j = 0; j < 128; ++j) {
            for (int i = 0; i < 128; ++i) {
                const auto at = [&](const Surface& map) {
                    return static_cast<double>(
                        map.channel(channel)[static_cast<std::size_t>(j * map.resolution() + i)]);
                };
                most = std::max(most, std::abs(at(whole) - at(region)));
            }
        }
        EXPECT_LE(most, 1e-6 * height) << "channel " << static_cast<int>(channel);
    }
}

INSTANTIATE_TEST_SUITE_P(Depths, Deep,
                         testing::Values(20.0, 60.0, std::numeric_limits<double>::infinity()));

TEST(ShoreSurface, RegionsHaveTheSameBitsForAnyNumberOfThreads) {
    const Domain domain = square(600.0, 200.0, 64, 3.0);
    const ChannelSet channels = {Channel::height, Channel::nx, Channel::vz, Channel::foam};
    Ocean one(beach_sea(), {.threads = 1});
    Ocean three(beach_sea(), {.threads = 3});
    const Surface a = one.region(11.0, domain, channels);
    const Surface b = three.region(11.0, domain, channels);
    for (const Channel channel : {Channel::height, Channel::nx, Channel::vz, Channel::foam}) {
        EXPECT_TRUE(std::ranges::equal(a.channel(channel), b.channel(channel)));
    }
}

TEST(ShoreSurface, NoWaveFoldsOrExceedsWhatItsDepthCarries) {
    Ocean ocean(beach_sea());
    const Domain domain = square(500.0, 60.0, 151, 2.0);
    for (const double time : {3.0, 40.0}) {
        const Surface map = ocean.region(
            time, domain, {Channel::height, Channel::jacobian, channel_of(LandMask::depth)});
        EXPECT_GT(*std::ranges::min_element(map.channel(Channel::jacobian)), 0.15f);
        for (int i = 0; i < 151; ++i) {
            const double depth = std::max(0.6, (300.0 - 2.0 * i) / 40.0);
            for (int j = 0; j < 151; ++j) {
                const float height =
                    map.channel(Channel::height)[static_cast<std::size_t>(j * 151 + i)];
                // Short waves that are in no band add a little to the limited ones.
                EXPECT_LE(static_cast<double>(height), 1.05 * depth + 0.1);
            }
        }
    }
}

TEST(ShoreSurface, SteepBeachesEndTheDisplacementWithoutFolds) {
    Ocean ocean(beach_sea(8.0));
    for (const double time : {3.0, 40.0}) {
        const Surface map = ocean.region(time, square(700.0, 60.0, 81, 2.0), Channel::jacobian);
        EXPECT_GT(*std::ranges::min_element(map.channel(Channel::jacobian)), 0.15f);
    }
}

TEST(ShoreSurface, SlopesAndVelocitiesAreTheDerivativesOfTheSurface) {
    Ocean ocean(beach_sea());
    constexpr double kStep = 0.25;
    constexpr double kTick = 0.01;
    double error_slope = 0.0, slopes = 0.0, error_rate = 0.0, rates = 0.0;
    const auto at = [&](double x, double y, double t, Channel channel) {
        return static_cast<double>(
            ocean.region(t, {{x, y}, {90.0, 90.0}, {10, 10}, false}, channel).channel(channel)[0]);
    };
    for (int n = 0; n < 24; ++n) {
        const double x = 560.0 + 9.7 * n;
        const double y = 120.0 + 11.3 * n;
        const double slope = at(x, y, 20.0, Channel::slope_x);
        const double difference =
            (at(x + kStep, y, 20.0, Channel::height) - at(x - kStep, y, 20.0, Channel::height)) /
            (2.0 * kStep);
        error_slope += std::pow(slope - difference, 2);
        slopes += slope * slope;
        const double rate = at(x, y, 20.0, Channel::vz);
        const double change =
            (at(x, y, 20.0 + kTick, Channel::height) - at(x, y, 20.0 - kTick, Channel::height)) /
            (2.0 * kTick);
        error_rate += std::pow(rate - change, 2);
        rates += rate * rate;
    }
    EXPECT_LE(std::sqrt(error_slope / slopes), 0.01);
    EXPECT_LE(std::sqrt(error_rate / rates), 1e-3);
}

TEST(ShoreSurface, QueriesFindTheSurfaceThatRegionsShow) {
    Ocean ocean(beach_sea());
    const Domain domain = square(560.0, 100.0, 24, 9.0);
    const Surface map = ocean.region(9.0, domain, {Channel::dx, Channel::dy, Channel::height});
    std::vector<WorldPoint> points;
    for (int j = 0; j < 24; ++j) {
        for (int i = 0; i < 24; ++i) {
            const auto at = static_cast<std::size_t>(j * 24 + i);
            const auto [x, y] = domain.place(i, j);
            points.push_back({x + static_cast<double>(map.channel(Channel::dx)[at]),
                              y + static_cast<double>(map.channel(Channel::dy)[at])});
        }
    }
    std::vector<QuerySample> samples(points.size());
    ocean.query(9.0, points, samples, {.foam = false});
    for (std::size_t i = 0; i < points.size(); ++i) {
        EXPECT_FALSE(samples[i].undecided);
        EXPECT_NEAR(samples[i].height, static_cast<double>(map.channel(Channel::height)[i]), 3e-5);
    }
}

TEST(ShoreSurface, CrossesTheBorderOfTheBedWithoutASeam) {
    Ocean ocean(beach_sea());
    // Across the southern border, over 2 to 8 m of water.
    const Domain domain{{480.0, -100.0}, {240.0, 240.0}, {121, 121}, false};
    const Surface map = ocean.region(30.0, domain, Channel::height);
    const std::span<const float> height = map.channel(Channel::height);
    double near = 0.0, far = 0.0;
    for (int j = 1; j < 120; ++j) {
        const double y = domain.place(0, j)[1];
        for (int i = 0; i < 121; ++i) {
            const auto at = [&](int row) {
                return static_cast<double>(height[static_cast<std::size_t>(row * 121 + i)]);
            };
            const double bend = std::abs(at(j + 1) - 2.0 * at(j) + at(j - 1));
            double& most = y > -6.0 && y < 70.0 ? near : far;
            most = std::max(most, bend);
        }
    }
    EXPECT_LE(near, 1.2 * far);
}

TEST(ShoreSurface, WaterMovesWithTheSurfaceAndStandsStillInTheBed) {
    Ocean ocean(beach_sea());
    double error = 0.0, all = 0.0;
    constexpr double kTick = 0.02;
    std::vector<QuerySample> before(1), after(1);
    for (int n = 0; n < 6; ++n) {
        // 15 to 10 m of water: the vertical velocity at z = 0 is the rate of the height.
        const WaterPoint place{200.0 + 37.0 * n, 130.0 + 9.0 * n, 0.0};
        WaterMotion motion;
        ocean.water_motion(21.0, {&place, 1}, {&motion, 1});
        const auto height = [&](double time) {
            return static_cast<double>(
                ocean.region(time, {{place.x, place.y}, {8.0, 8.0}, {2, 2}, false}, Channel::height)
                    .channel(Channel::height)[0]);
        };
        const double rate = (height(21.0 + kTick) - height(21.0 - kTick)) / (2.0 * kTick);
        error += std::pow(motion.velocity_z - rate, 2);
        all += rate * rate;
    }
    // Linear theory lacks the crest shape's share.
    EXPECT_LE(std::sqrt(error / all), 0.05);
    const WaterPoint in_the_bed{600.0, 200.0, -6.0};
    WaterMotion motion;
    ocean.water_motion(21.0, {&in_the_bed, 1}, {&motion, 1});
    EXPECT_EQ(motion, WaterMotion{});
}

// Exact queries sum modes where the others interpolate: from beyond the border to the run-up the
// two differ by the error of the interpolation, which is 2e-6 of the waves, and no more than that
// by rounding. Motions sum too; without that they lack the error of OrbitalMotion, which at this
// resolution is up to 3e-3 of the waves' speed.
TEST(ShoreSurface, ExactQueriesDifferFromOthersByTheInterpolationAlone) {
    Ocean ocean(beach_sea());
    std::vector<WorldPoint> points;
    std::vector<WaterPoint> depths;
    for (int i = 0; i < 48; ++i) {
        points.push_back({-60.0 + 18.3 * i, 10.0 + 5.1 * i});
        depths.push_back({points.back().x, points.back().y, -1.0});
    }
    std::vector<QuerySample> sums(points.size()), reads(points.size());
    std::vector<WaterMotion> exact(points.size()), motions(points.size());
    ocean.query(9.0, points, sums, {.exact = true, .foam = false});
    ocean.query(9.0, points, reads, {.foam = false});
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
    std::vector<QuerySample> again(points.size());
    alone.query(8.0, points, again, {.foam = false});
    alone.query(9.0, points, again, {.exact = true, .foam = false});
    for (std::size_t i = 0; i < points.size(); ++i) EXPECT_EQ(sums[i].height, again[i].height);
}

TEST(ShoreSurface, GaugesReadWhatQueriesFind) {
    Ocean ocean(beach_sea());
    Gauge gauge{"surf", {{0.0, {640.0, 150.0, -1.0}}}};
    ThreadPool pool(1);
    const GaugeSeries series =
        read_gauge_series(ocean, {gauge}, {5.0, 6.0, 2.0}, pool, [](std::size_t) {});
    ASSERT_EQ(series.times, 3u);
    const WorldPoint point{640.0, 150.0};
    QuerySample sample;
    ocean.query(5.5, {&point, 1}, {&sample, 1}, {.exact = true, .foam = false});
    EXPECT_EQ(series.reading(1, 0)[GaugeSeries::kElevation], sample.height);
}

TEST(ShoreSurface, SeaAroundACoastIsTheSeaWithoutABedAndHasItsModesOnce) {
    Parameters parameters = beach_sea();
    Ocean coast(parameters);
    parameters.water.bed = nullptr;
    Ocean sea(parameters);
    constexpr ChannelSet kMaps = {Channel::dx, Channel::height, Channel::foam};
    coast.region(2.0, square(700.0, 100.0, 8, 4.0), Channel::height);
    const Surface around = coast.open_sea().evaluate(2.0, kMaps, 256);
    const Surface open = sea.evaluate(2.0, kMaps, 256);
    for (const Channel channel : {Channel::dx, Channel::height, Channel::foam}) {
        EXPECT_TRUE(std::ranges::equal(around.channel(channel), open.channel(channel)));
    }
    EXPECT_EQ(coast.stage_runs().modes, 1);
    EXPECT_EQ(coast.stage_runs().spectrum, 1);
}

TEST(ShoreSurface, SeaAroundACoastGoesOnWithTheFoamOfAnObjectOfTheSameWaves) {
    const OceanOptions options{.foam_start = FoamStart::empty};
    const auto foam_at = [](Ocean& ocean, double time) {
        const Surface map = ocean.open_sea().evaluate(time, Channel::foam, 256);
        const auto foam = map.channel(Channel::foam);
        return std::vector<float>(foam.begin(), foam.end());
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
        try {
            call();
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::unsupported) << error.what();
            EXPECT_NE(std::string(error.what()).find(sentence), std::string::npos) << error.what();
            return;
        }
        ADD_FAILURE() << "allowed: " << sentence;
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
    Ocean open(surf_sea(20.0));
    refuses("has no bed", [&] { open.region(0.0, square(0, 0, 8, 1.0), Channel::height); });
    refuses("has no bed", [&] { open.prepare_coast(); });
}

}  // namespace
}  // namespace ocean
