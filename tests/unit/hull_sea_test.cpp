// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A sea with hulls is one surface: regions and queries show the open sea plus the wakes.
#include "hulls/hull_marks.hpp"
#include "hulls/wake.hpp"
#include "ocean/internal/hull_rules.hpp"
#include "ocean/internal/open_sea.hpp"
#include "ocean/land_mask.hpp"
#include "ocean/ocean.hpp"
#include "ocean/sea_bed.hpp"
#include "refusal.hpp"
#include "test_seas.hpp"

namespace ocean {
namespace {

Hull boat(double speed = 5.0) {
    Hull hull;
    hull.length = 12.0;
    hull.beam = 3.0;
    hull.draught = 0.8;
    hull.wake_resolution = 64;
    auto track = std::make_shared<HullTrack>();
    track->rows = {{-100.0, -100.0 * speed, 20.0}, {100.0, 100.0 * speed, 20.0}};
    hull.track = track;
    return hull;
}

Parameters sea_with_boat() {
    Parameters parameters = test::wind_sea(64, 200.0);
    parameters.hulls.push_back(boat());
    return parameters;
}

/// The stern and the wake of the boat at 3 s.
const Domain kWake{{-60.0, 0.0}, {80.0, 40.0}, {41, 21}, false};
constexpr double kTime = 3.0;

TEST(HullSea, AQueryFindsTheSurfaceOfTheRegion) {
    Ocean ocean(sea_with_boat());
    const Surface map = ocean.region(
        kTime, kWake,
        {Channel::dx, Channel::dy, Channel::height, Channel::nx, Channel::vz, Channel::foam});
    const double height = ocean.state().significant_wave_height.resolved;
    std::vector<WorldPoint> points;
    std::vector<std::size_t> at;
    for (int j = 0; j < 21; j += 4) {
        for (int i = 0; i < 41; i += 4) {
            const auto n = static_cast<std::size_t>(j * 41 + i);
            const auto [x, y] = kWake.place(i, j);
            points.push_back({x + static_cast<double>(map.channel(Channel::dx)[n]),
                              y + static_cast<double>(map.channel(Channel::dy)[n])});
            at.push_back(n);
        }
    }
    std::vector<QuerySample> samples(points.size());
    ocean.query(kTime, points, samples);
    std::vector<QuerySample> exact(points.size());
    ocean.query(kTime, points, exact, {.exact = true, .foam = false});
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto of = [&](Channel channel) {
            return static_cast<double>(map.channel(channel)[at[i]]);
        };
        EXPECT_NEAR(samples[i].height, of(Channel::height), 1e-5 * height);
        EXPECT_NEAR(samples[i].normal[0], of(Channel::nx), 1e-4);
        EXPECT_NEAR(samples[i].velocity[2], of(Channel::vz), 1e-4);
        EXPECT_NEAR(samples[i].foam, of(Channel::foam), 1e-3);
        EXPECT_NEAR(exact[i].height, of(Channel::height), 3e-3 * height);
    }
}

TEST(HullSea, OnCalmWaterAQueryFindsTheWakeToItsOwnScale) {
    Parameters calm = sea_with_boat();
    calm.waves.front().wind_speed = 0.0;
    Ocean ocean(calm);
    const Surface map = ocean.region(kTime, kWake, {Channel::dx, Channel::dy, Channel::height});
    const std::span<const float> heights = map.channel(Channel::height);
    std::vector<WorldPoint> points;
    double squares = 0.0;
    for (std::size_t n = 0; n < heights.size(); ++n) {
        const auto [x, y] = kWake.place(static_cast<int>(n % 41), static_cast<int>(n / 41));
        points.push_back({x + static_cast<double>(map.channel(Channel::dx)[n]),
                          y + static_cast<double>(map.channel(Channel::dy)[n])});
        squares += static_cast<double>(heights[n]) * static_cast<double>(heights[n]);
    }
    const double rms = std::sqrt(squares / static_cast<double>(heights.size()));
    EXPECT_GT(rms, 0.01);
    std::vector<QuerySample> samples(points.size());
    ocean.query(kTime, points, samples);
    for (std::size_t n = 0; n < heights.size(); ++n) {
        EXPECT_NEAR(samples[n].height, static_cast<double>(heights[n]), 1e-5 * rms) << n;
    }
}

class HullSeaOrder : public testing::TestWithParam<bool> {};

TEST_P(HullSeaOrder, IsTheMapOfTheOpenSeaPlusTheWake) {
    Parameters parameters = sea_with_boat();
    parameters.grid.resolution = 128;  // holds the bound waves that are shown
    parameters.surface.second_order = GetParam();
    parameters.surface.shortest_wavelength = 8.0;
    Ocean ocean(parameters);
    const double step = 200.0 / 128;
    const Domain there{{0.0, 0.0}, {64 * step, 32 * step}, {65, 33}, false};
    const ChannelSet channels = {Channel::dx,      Channel::dy,      Channel::height,
                                 Channel::slope_x, Channel::slope_y, Channel::vz};
    const Surface both = ocean.region(kTime, there, channels);
    const Surface open = ocean.evaluate(kTime, channels, 128);
    Surface wake(there, kTime, channels);
    ocean.wake_into(0, kTime, there, outputs_of(wake));
    parameters.surface.second_order = false;
    const Surface first_order = Ocean(parameters).evaluate(kTime, {Channel::height}, 128);
    const double height = ocean.state().significant_wave_height.resolved;
    std::vector<WorldPoint> points;
    double bound = 0.0, highest = 0.0;
    for (const auto [i, j, at] : test::cells(65, 33)) {
        const auto sample = static_cast<std::size_t>(j * 128 + i);
        for (const Channel channel :
             {Channel::dx, Channel::height, Channel::slope_x, Channel::slope_y, Channel::vz}) {
            EXPECT_NEAR(both.channel(channel)[at],
                        open.channel(channel)[sample] + wake.channel(channel)[at], 3e-5 * height);
        }
        const auto of = [at = at](const Surface& map, Channel channel) {
            return static_cast<double>(map.channel(channel)[at]);
        };
        highest = std::max(highest, std::abs(of(wake, Channel::height)));
        const auto second = static_cast<double>(open.channel(Channel::height)[sample] -
                                                first_order.channel(Channel::height)[sample]);
        bound = std::max(bound, std::abs(second));
        const auto [x, y] = there.place(i, j);
        points.push_back({x + of(both, Channel::dx), y + of(both, Channel::dy)});
    }
    EXPECT_GT(highest, 0.05);
    EXPECT_EQ(bound > 0.01 * height, GetParam());
    std::vector<QuerySample> quick(points.size());
    ocean.query(kTime, points, quick, {.foam = false});
    std::vector<QuerySample> exact(8);
    ocean.query(kTime, std::span(points).subspan(1000, 8), exact, {.exact = true, .foam = false});
    for (std::size_t i = 0; i < points.size(); ++i) {
        EXPECT_NEAR(quick[i].height, both.channel(Channel::height)[i], 1e-5 * height);
    }
    for (std::size_t i = 0; i < exact.size(); ++i) {
        EXPECT_NEAR(exact[i].height, quick[1000 + i].height, 3e-3 * height);
    }
}

INSTANTIATE_TEST_SUITE_P(FirstAndSecond, HullSeaOrder, testing::Bool());

TEST(HullSea, MapsOfOnePeriodKeepTheirBitsAndWarn) {
    Ocean with(sea_with_boat());
    Ocean without(test::wind_sea(64, 200.0));
    const ChannelSet channels = {Channel::height, Channel::foam};
    const Surface a = with.evaluate(kTime, channels, 64);
    const Surface b = without.evaluate(kTime, channels, 64);
    EXPECT_TRUE(test::same_bits(a, b));
    EXPECT_TRUE(test::says(with.state().warnings, "wakes of hulls"));
    EXPECT_FALSE(test::says(without.state().warnings, "wakes of hulls"));
}

TEST(HullSea, WavesThatTheoryOrSamplesCannotHoldAreWarnedOf) {
    const auto warns = [](const Parameters& parameters, std::string_view words) {
        return bool(test::says(Ocean(parameters).state().warnings, words));
    };
    constexpr std::string_view kSteep = "linear theory", kCoarse = "which leave most of them out";
    Parameters parameters = sea_with_boat();
    Hull& hull = parameters.hulls.front();
    hull.factor = 0.1;
    EXPECT_FALSE(warns(parameters, kSteep));
    EXPECT_FALSE(warns(parameters, kCoarse));
    hull.factor = 10.0;
    EXPECT_TRUE(warns(parameters, kSteep));
    hull.wake_size = 5000.0;  // samples 78 m apart, waves of 16 m
    EXPECT_TRUE(warns(parameters, kCoarse));
}

TEST(HullSea, TheStateDescribesItsHulls) {
    const std::vector<HullSummary> hulls = Ocean(sea_with_boat()).state().hulls;
    ASSERT_EQ(hulls.size(), 1u);
    EXPECT_DOUBLE_EQ(hulls[0].begin, -100.0);
    EXPECT_DOUBLE_EQ(hulls[0].end, 100.0);
    EXPECT_DOUBLE_EQ(hulls[0].speed, 5.0);
    EXPECT_NEAR(hulls[0].froude_number, 0.46, 0.01);
    EXPECT_NEAR(hulls[0].volume, 2.0 / 3.0 * 12.0 * 3.0 * 0.8, 1e-9);
    EXPECT_NEAR(hulls[0].wavelength, 16.0, 0.1);
    EXPECT_GT(hulls[0].wave_height, 0.1);
    EXPECT_LT(hulls[0].wave_height, 1.0);
    EXPECT_DOUBLE_EQ(hulls[0].wake_cell, hulls[0].wake_size / 64.0);
}

TEST(HullSea, ATrailChangesWithItsLifetime) {
    constexpr Channel kTrail = channel_of(LandMask::trail);
    Ocean ocean(sea_with_boat());
    const Surface before = ocean.region(kTime, kWake, kTrail);
    ocean.set("hulls.0.trail_lifetime", "50");
    const Surface after = ocean.region(kTime, kWake, kTrail);
    EXPECT_GT(std::ranges::max(after.channel(kTrail)), std::ranges::max(before.channel(kTrail)));
    EXPECT_FALSE(ocean.parameters().hulls == sea_with_boat().hulls);
}

TEST(HullSea, AnotherBoatAddsItsWakeAndAFactorScalesIt) {
    Parameters parameters = sea_with_boat();
    parameters.waves.front().wind_speed = 0.0;
    Ocean ocean(parameters);
    const Surface one = ocean.region(kTime, kWake, Channel::height);
    ocean.set("hulls.0.factor", "2");
    const Surface twice = ocean.region(kTime, kWake, Channel::height);
    parameters.hulls.push_back(parameters.hulls.front());
    const Surface two = Ocean(parameters).region(kTime, kWake, Channel::height);
    for (std::size_t i = 0; i < kWake.count(); ++i) {
        const float h = one.channel(Channel::height)[i];
        EXPECT_NEAR(twice.channel(Channel::height)[i], 2.0f * h, 1e-6);
        EXPECT_NEAR(two.channel(Channel::height)[i], 2.0f * h, 1e-6);
    }
}

TEST(HullSea, AloneAndInASequenceAreTheSameBits) {
    const ChannelSet channels = {Channel::height, Channel::vx, Channel::whitecap, Channel::foam};
    Ocean sequence(sea_with_boat());
    for (const double time : {1.0, 5.0, 2.0}) sequence.region(time, kWake, channels);
    const Surface a = sequence.region(kTime, kWake, channels);
    const Surface b = Ocean(sea_with_boat(), {.threads = 1}).region(kTime, kWake, channels);
    EXPECT_TRUE(test::same_bits(a, b));
}

TEST(HullSea, ATakeChangesTheSeaUnderTheBoat) {
    Sea sea{sea_with_boat(), {}};
    sea.take.events.push_back({1.0, find_parameter("wind_speed"), 14.0});
    Ocean alone(sea);
    const Surface a = alone.region(kTime, kWake, Channel::height);
    Ocean sequence(sea);
    sequence.region(0.5, kWake, Channel::height);
    const Surface b = sequence.region(kTime, kWake, Channel::height);
    EXPECT_TRUE(test::same_bits(a, b));
}

TEST(HullSea, TheWindTearsSprayOffItsBowWave) {
    // A strong wind over low waves, none of which breaks beside the steep wake of a heavy boat.
    Parameters parameters = sea_with_boat();
    parameters.waves.front().wind_speed = 15.0;
    parameters.waves.front().significant_wave_height = 0.05;
    parameters.surface.foam_coverage = FoamCoverage::threshold;
    parameters.surface.foam_threshold = 0.85;
    parameters.hulls.front().factor = 8.0;
    const SpraySettings settings{.lifetime = 0.3, .density = 40.0};
    Ocean alone(parameters), sequence(parameters);
    EXPECT_TRUE(alone.spray(kTime, settings).empty());
    const std::vector<SprayParticle> particles = alone.spray(kTime, settings, kWake);
    ASSERT_GT(particles.size(), 20u);
    EXPECT_LE(particles.size(), max_spray_particles(alone.sea(), settings, kWake));
    for (const SprayParticle& particle : particles) {
        EXPECT_GT(particle.x, -70.0);
        EXPECT_LT(particle.x, 30.0);
        EXPECT_NEAR(particle.y, 20.0, 25.0);
    }
    for (const double time : {2.5, 2.9}) sequence.spray(time, settings, kWake);
    sequence.spray(2.9, settings);  // of the open sea between
    const std::vector<SprayParticle> again = sequence.spray(kTime, settings, kWake);
    ASSERT_EQ(again.size(), particles.size());
    for (std::size_t i = 0; i < again.size(); ++i) {
        EXPECT_EQ(again[i].id, particles[i].id);
        EXPECT_EQ(again[i].x, particles[i].x);
        EXPECT_EQ(again[i].z, particles[i].z);
    }
    // Cells of 0.1 m around the bow: none of those well inside of it throws any.
    const Domain near{{17.0, 17.0}, {6.0, 6.0}, {13, 13}, false};
    Hull core = parameters.hulls.front();
    core.length = 11.6;
    core.beam = 2.4;
    HullMarks inside(core, 0.0);
    int young = 0;
    for (const SprayParticle& particle : alone.spray(kTime, settings, near)) {
        if (particle.age > 0.05) continue;  // the wind has carried it
        ++young;
        inside.move_to(kTime - particle.age);
        EXPECT_LT(inside.inside({particle.x - particle.age * particle.vx,
                                 particle.y - particle.age * particle.vy}),
                  0.5f);
    }
    EXPECT_GT(young, 10);
    parameters.hulls.clear();
    EXPECT_THROW(Ocean(parameters).spray(kTime, settings, kWake), Error);
}

TEST(HullSea, AFloatRisesOnAWake) {
    Parameters parameters = sea_with_boat();
    parameters.waves.front().wind_speed = 0.0;
    Ocean ocean(parameters);
    // Beside the boat, which is at 15 m.
    const FloatBody buoy{.x = 0.0, .y = 26.0, .heading = 0.0, .length = 1.0, .width = 1.0};
    double highest = 0.0;
    for (double time = 0.0; time < 8.0; time += 1.0) {
        FloatPose pose;
        ocean.float_poses(time, {&buoy, 1}, {&pose, 1});
        highest = std::max(highest, std::abs(pose.position[2]));
    }
    EXPECT_GT(highest, 0.05);
}

std::string refusal(const Parameters& parameters) {
    return test::message_of([&] { validate(parameters); });
}

TEST(HullSea, RefusesWhatItCannotHold) {
    Ocean ocean(sea_with_boat());
    EXPECT_FALSE(ocean.repeats());
    const WorldPoint place{0.0, 0.0};
    QuerySample sample;
    EXPECT_THROW(ocean.query(0.0, {&place, 1}, {&sample, 1}, {.resolution = 32}), Error);
    EXPECT_THROW(ocean.region(0.0, Domain::tile(100.0, 32), Channel::height), Error);
    const auto changed = [](const auto& change) {
        Parameters parameters = sea_with_boat();
        change(parameters, parameters.hulls.front());
        return refusal(parameters);
    };
    EXPECT_EQ(changed([](Parameters&, Hull&) {}), "");
    EXPECT_EQ(
        changed([](Parameters&, Hull& hull) { hull.track = nullptr; }),
        "hulls.0: has no track; allowed: track = [[time, x, y], ...] or track_file = a CSV or GPX "
        "file");
    EXPECT_EQ(changed([](Parameters&, Hull& hull) { hull.wake_size = 40.0; }),
              "hulls.0.wake_size = 40 m: does not hold the hull and its waves; allowed: 0, or at "
              "least four lengths of the hull, 48 m");
    EXPECT_EQ(changed([](Parameters& sea, Hull&) { sea.water.depth = 0.5; }),
              "hulls.0.draught = 0.8 m; allowed: less than water.depth = 0.5 m");
    EXPECT_EQ(changed([](Parameters& sea, Hull&) { sea.time.loop_period = 60.0; }),
              "hulls.0.track: ends 1000 m from where it begins, and the sea loops; allowed: with "
              "time.loop_period = 60 s: a track that ends where it began, in a whole part of the "
              "loop");
    const auto flat = [](Parameters& sea, Hull&) {
        GivenBed given;
        given.grid = {{0.0, 0.0}, {160.0, 160.0}, {17, 17}, false};
        given.heights.assign(17 * 17, -20.0f);
        sea.water.bed = make_sea_bed(std::move(given), sea.water);
    };
    EXPECT_EQ(changed(flat),
              "hulls: a hull needs an open sea: over a bed its waves would refract, which is not "
              "computed; allowed: no hulls with water.seabed");
    Parameters many = sea_with_boat();
    auto track = std::make_shared<HullTrack>();
    for (int i = 0; i < 1'000'000; ++i) track->rows.push_back({0.5 * i, 0.0, 0.0});
    many.hulls.front().track = track;
    EXPECT_EQ(refusal(many),
              "hulls.0.track: makes 1000000 rows of tracks; allowed: at most 50000 of all hulls "
              "together; a row for each second is plenty");
}

TEST(HullSea, TheWaterBelowMovesAsItsWakesDo) {
    // At the level of still water it moves as the surface does, to the error of splines.
    Parameters parameters = sea_with_boat();
    parameters.surface.choppiness = 1.0;
    Ocean ocean(parameters);
    const Domain behind{{-40.0, 14.0}, {30.0, 12.0}, {4, 4}, false};
    const Surface region = ocean.region(kTime, behind, {Channel::vx, Channel::vy, Channel::vz});
    std::vector<WaterPoint> points;
    for (int j = 0; j < 4; ++j) {
        for (int i = 0; i < 4; ++i) {
            const auto [x, y] = behind.place(i, j);
            points.push_back({x, y, 0.0});
        }
    }
    points.push_back({-40.0, 20.0, -4.0});
    std::vector<WaterMotion> motions(points.size()), exact(points.size()), open(points.size());
    ocean.water_motion(kTime, points, motions);
    ocean.water_motion(kTime, points, exact, {.exact = true});
    ocean.open_sea().water_motion(kTime, points, open, {});
    double fastest = 0.0;
    for (std::size_t n = 0; n < 16; ++n) {
        const auto shown = [&](Channel channel) {
            return static_cast<double>(region.channel(channel)[n]);
        };
        EXPECT_NEAR(motions[n].velocity_x, shown(Channel::vx), 4e-3);
        EXPECT_NEAR(motions[n].velocity_y, shown(Channel::vy), 4e-3);
        EXPECT_NEAR(motions[n].velocity_z, shown(Channel::vz), 4e-3);
        EXPECT_NEAR(motions[n].velocity_z, exact[n].velocity_z, 4e-3);
        EXPECT_NEAR(motions[n].pressure, exact[n].pressure, 5.0);
        fastest = std::max(fastest, std::abs(motions[n].velocity_z - open[n].velocity_z));
    }
    EXPECT_GT(fastest, 0.1);
    // Waves of 16 m are a fifth at 4 m.
    const double deep = std::abs(motions[16].velocity_z - open[16].velocity_z);
    EXPECT_GT(deep, 1e-4);
    EXPECT_LT(deep, 0.3 * fastest);
}

}  // namespace
}  // namespace ocean
