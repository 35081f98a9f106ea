// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Regions of a sea over its bed compute what their channels need, and that does not change what
// they show.

#include <set>

#include "coast/statics/shore_statics.hpp"
#include "ocean/internal/directional_spectrum.hpp"
#include "ocean/land_mask.hpp"
#include "ocean/query.hpp"
#include "test_beds.hpp"
#include "test_seas.hpp"

namespace ocean {
namespace {

/// Lays a beach that rises 1:40 to the east below a sea in 20 m; still water ends at x = `shore`.
Parameters over_beach(const Parameters& sea, int columns, int rows, double cell, double shore) {
    return test::over(sea, test::bed_of(columns, rows, cell, [=](double x, double) {
                          return std::max(-20.0, (x - shore) / 40.0);
                      }));
}

Parameters beach_sea() {
    return over_beach(test::coast_sea(128, 1024.0, 20.0), 129, 65, 8.0, 800.0);
}

TEST(ShoreChannels, HeightsHaveTheSameBitsInEveryRegionAndBesideEveryChannel) {
    // From 80 m beyond the border of the bed into the surf.
    using enum Channel;
    const Domain domain{{500.0, -80.0}, {300.0, 300.0}, {41, 41}, false};
    Ocean ocean(beach_sea());
    const Surface plain = ocean.region(4.0, domain, {dx, dy, height});
    EXPECT_TRUE(test::same_bits(ocean.region(4.0, domain, {dx, dy, height, nx, whitecap}), plain));
    EXPECT_TRUE(test::same_bits(ocean.region(4.0, domain, {dx, dy, height, vz}), plain));
    const Domain whole{{480.0, 100.0}, {160.0, 160.0}, {81, 81}, false};
    const Domain part{{540.0, 120.0}, {80.0, 60.0}, {41, 31}, false};
    const Surface large = ocean.region(4.0, whole, height), small = ocean.region(4.0, part, height);
    for (const auto [i, j, at] : test::cells<std::size_t>(41, 31)) {
        EXPECT_EQ(small.channel(height)[at], large.channel(height)[(j + 10) * 81 + i + 30]);
    }
}

TEST(ShoreChannels, FoamAndWetGroundShareTheReadsOfATime) {
    const Domain beach{{700.0, 100.0}, {120.0, 60.0}, {31, 16}, false};
    const ChannelSet traces = {Channel::foam, channel_of(LandMask::wetness)};
    // At 4 s both clocks tick.
    const auto ticks = [&](Ocean& ocean, ChannelSet channels) {
        static_cast<void>(ocean.region(3.9, beach, channels));
        const int before = ocean.stage_runs().foam_ticks;
        static_cast<void>(ocean.region(4.1, beach, channels));
        return ocean.stage_runs().foam_ticks - before;
    };
    Ocean ocean(beach_sea());
    Ocean foam(beach_sea());
    EXPECT_EQ(ticks(ocean, traces), ticks(foam, Channel::foam));
    const Surface followed = ocean.region(4.1, beach, traces);
    EXPECT_TRUE(test::same_bits(followed, Ocean(beach_sea()).region(4.1, beach, traces)));
    const Channel wet = channel_of(LandMask::wetness);  // which alone reads the swash alone
    const Surface alone = Ocean(beach_sea()).region(4.1, beach, wet);
    EXPECT_TRUE(std::ranges::equal(alone.channel(wet), followed.channel(wet)));
}

TEST(ShoreChannels, ATimeOfFoamAtPointsIsNoWholeSurface) {
    const Domain beach{{700.0, 100.0}, {120.0, 60.0}, {31, 16}, false};
    const WorldPoint point{770.0, 110.0};
    QuerySample sample;
    Ocean ocean(beach_sea());
    ocean.query(4.1, {&point, 1}, {&sample, 1});  // the last tick is at 4 s
    EXPECT_TRUE(test::same_bits(ocean.region(4.0, beach, Channel::height),
                                Ocean(beach_sea()).region(4.0, beach, Channel::height)));
}

TEST(ShoreChannels, ARegionGoesIntoInterleavedPaddedBuffersWithFactors) {
    const Domain domain{{600.0, 100.0}, {600.0, 40.0}, {301, 21}, false};  // rows of two pieces
    const ChannelSet channels = {Channel::height, Channel::nx, Channel::jacobian};
    Ocean ocean(beach_sea());
    const Surface map = ocean.region(4.0, domain, channels);
    constexpr std::size_t kPitch = 3 * 301 + 5;
    std::vector<float> buffer(21 * kPitch, -7.0f);
    MapOutput output{buffer.data(), 3, {}};
    output.component = {{{Channel::nx, 2.0f}, {}, {Channel::height, -1.0f}}};
    output.row_pitch = kPitch;
    ocean.region_into(4.0, domain, std::span(&output, 1));
    for (std::size_t j = 0; j < 21; ++j) {
        for (std::size_t i = 0; i < 301; ++i) {
            const float* const sample = &buffer[j * kPitch + 3 * i];
            ASSERT_EQ(sample[0], 2.0f * map.channel(Channel::nx)[j * 301 + i]);
            ASSERT_EQ(sample[1], -7.0f) << "a component without a quantity stays unchanged";
            ASSERT_EQ(sample[2], -map.channel(Channel::height)[j * 301 + i]);
        }
        for (std::size_t pad = 0; pad < 5; ++pad) {
            ASSERT_EQ(buffer[j * kPitch + 903 + pad], -7.0f);
        }
    }
}

TEST(ShoreChannels, LandThatNoWaveReachesHasNoFoamOfTheOpenSea) {
    Parameters parameters = beach_sea();
    parameters.waves.front().wind_speed = 18.0;
    parameters.waves.front().wind_direction = 180.0;  // from the land
    Ocean ocean(parameters);
    // The bed is 2.5 m high at x = 900 m and rises.
    const Domain land{{900.0, 100.0}, {56.0, 300.0}, {15, 76}, false};
    const Surface map = ocean.region(4.0, land, {Channel::foam, Channel::cover, Channel::whitecap});
    for (const Channel channel : {Channel::foam, Channel::cover, Channel::whitecap}) {
        EXPECT_EQ(std::ranges::max(map.channel(channel)), 0.0f);
    }
}

/// Waves of Hs 1.5 m and 6 s, to the east.
Parameters short_sea(double depth) {
    Parameters parameters = test::coast_sea(128, 512.0, depth);
    parameters.waves.front().significant_wave_height = 1.5;
    parameters.waves.front().peak_period = 6.0;
    return parameters;
}

/// A polder 3 m below the water, ringed by dikes of 5 m of which one lies along the border of the
/// bed, at the end of a beach.
Parameters polder_sea() {
    return test::over(
        short_sea(10.0), test::bed_of(161, 121, 5.0, [](double x, double y) {
            const bool dike = x < 430.0 || x > 770.0 || y < 40.0 || y > 560.0;
            return x < 200.0 ? -10.0 : x < 400.0 ? -10.0 + (x - 200.0) * 0.075 : dike ? 5.0 : -3.0;
        }));
}

TEST(ShoreChannels, PondsAreLevelUpToTheirDikesAndHaveNoFoam) {
    Parameters wind = polder_sea();
    Parameters swell = wind;  // whose short waves are in no band, and which runs up high
    swell.waves.front().peak_period = 14.0;
    swell.waves.front().peak_enhancement = 8.0;
    constexpr std::size_t kSea = 32;
    std::vector<WorldPoint> points;
    for (std::size_t n = 0; n < kSea; ++n) {
        points.push_back({90.0, 80.0 + 14.0 * static_cast<double>(n)});
    }
    for (double y = 60.0; y < 550.0; y += 60.0) {
        for (const double x : {432.0, 436.0, 450.0, 600.0, 740.0, 769.0, 771.0}) {
            points.push_back({x, y});
        }
    }
    for (const bool has_foam : {true, false}) {
        Ocean ocean(has_foam ? wind : swell);
        const auto samples = test::query(ocean, 20.0, points, {.foam = has_foam});
        double foam = 0.0;
        for (std::size_t n = 0; n < kSea; ++n) foam += samples[n].foam;
        EXPECT_EQ(foam > 0.05 * kSea, has_foam);
        for (std::size_t n = kSea; n < points.size(); ++n) {
            EXPECT_NEAR(samples[n].height, 0.0, 0.01 * 1.5) << points[n].x << " " << points[n].y;
            EXPECT_EQ(samples[n].foam, 0.0) << points[n].x << " " << points[n].y;
        }
        // The maps of a region are the same surface.
        const Domain foot{{700.0, 300.0}, {72.0, 60.0}, {37, 16}, false};
        const Surface map = ocean.region(20.0, foot, {Channel::height, Channel::whitecap});
        EXPECT_EQ(std::ranges::max(map.channel(Channel::whitecap)), 0.0f);
        for (const float height : map.channel(Channel::height)) EXPECT_NEAR(height, 0.0f, 0.015f);
    }
}

/// The same waves over a bed 8 m deep, 400 m long, with walls 4 m high where `is_wall` says so.
Parameters walled_sea(const std::function<bool(int i, int j)>& is_wall) {
    return test::over(
        short_sea(8.0), test::bed_of(101, 101, 4.0, [&](double x, double y) {
            return is_wall(static_cast<int>(x / 4.0), static_cast<int>(y / 4.0)) ? 4.0 : -8.0;
        }));
}

/// Returns the rms height at each of some points, over times so far apart that they are
/// independent.
std::vector<double> rms_heights(const Parameters& parameters, const std::vector<WorldPoint>& points,
                                int times) {
    Ocean ocean(parameters);
    std::vector<double> heights(points.size());
    for (int n = 0; n < times; ++n) {
        const auto samples = test::query(ocean, 17.0 * n, points, {.foam = false});
        for (std::size_t p = 0; p < points.size(); ++p) {
            heights[p] += samples[p].height * samples[p].height / times;
        }
    }
    for (double& height : heights) height = std::sqrt(height);
    return heights;
}

TEST(ShoreChannels, TheLastWaterOfABeachHasTheWavesOfTheWaterBeforeIt) {
    // A beach of 1:30 that is oblique to the samples of its bed. Ground less than 0.15 m below
    // still water keeps some energy back, as a wall does, but lies before the land.
    const double turn = 0.4, c = std::cos(turn), s = std::sin(turn);
    const Parameters sea = test::over(
        test::coast_sea(128, 1024.0, 8.0), test::bed_of(161, 161, 3.0, [=](double x, double y) {
            return std::clamp(((x - 240.0) * c + (y - 240.0) * s) / 30.0, -8.0, 3.0);
        }));
    // Lines along the beach.
    const double beds[] = {-0.3, -0.12, -0.08, -0.04};
    std::vector<WorldPoint> points;
    for (const double bed : beds) {
        for (double along = -150.0; along <= 150.0; along += 3.0) {
            const double across = 30.0 * bed;
            points.push_back({240.0 + across * c - along * s, 240.0 + across * s + along * c});
        }
    }
    const std::vector<double> heights = rms_heights(sea, points, 12);
    const auto least_rms = [&](std::ptrdiff_t line) {
        return *std::min_element(heights.begin() + 101 * line, heights.begin() + 101 * (line + 1));
    };
    EXPECT_GT(least_rms(0), 0.1);
    for (const int line : {1, 2, 3}) EXPECT_GT(least_rms(line), 0.8 * least_rms(0)) << beds[line];
}

TEST(ShoreChannels, APondBehindWallsOfOneSampleIsLevelFromTheirFootOn) {
    // The maps of energy have cells of 16 m, which a cubic joins over a wall.
    Ocean ocean(walled_sea([](int i, int j) {
        const bool inside = i >= 50 && i <= 70 && j >= 40 && j <= 60;
        return inside && (i == 50 || i == 70 || j == 40 || j == 60);
    }));
    std::vector<WorldPoint> points;
    for (const double x : {204.0, 206.0, 210.0, 214.0, 240.0, 270.0, 276.0}) {
        for (const double y : {164.0, 168.0, 200.0, 236.0}) points.push_back({x, y});
    }
    const auto samples = test::query(ocean, 20.0, points, {.foam = false});
    for (std::size_t n = 0; n < points.size(); ++n) {
        EXPECT_NEAR(samples[n].height, 0.0, 0.015) << points[n].x << " " << points[n].y;
    }
}

TEST(ShoreChannels, WavesEightMetresBehindAThinWallAreThoseBehindAThickOne) {
    // A wall of one sample, 4 m above the water, and one of five; their northern ends are free.
    const auto height_behind = [](int width) {
        std::vector<WorldPoint> points;
        for (double y = 210.0; y < 260.0; y += 1.0) {
            for (const double x : {208.0, 212.0, 220.0, 232.0, 244.0}) points.push_back({x, y});
        }
        const auto is_wall = [&](int i, int j) { return i > 50 - width && i <= 50 && j < 70; };
        // A few times alone scatter by a quarter, since the waves behind the walls differ in phase.
        const std::vector<double> heights = rms_heights(walled_sea(is_wall), points, 24);
        std::vector<double> means(5);
        for (std::size_t p = 0; p < points.size(); ++p) {
            means[p % 5] += heights[p] * heights[p] / 50.0;
        }
        for (double& mean : means) mean = std::sqrt(mean);
        return means;
    };
    const std::vector<double> thin = height_behind(1), thick = height_behind(5);
    for (std::size_t n = 0; n < thin.size(); ++n) {
        EXPECT_LT(thin[n], 1.25 * thick[n]) << n;
        EXPECT_LT(thin[n], 0.375) << n;
    }
}

// A change of the sea computes delays of those waves only that no sea before had, and shows the
// bits of a sea that is made anew; so does a sea that comes back.
TEST(ShoreStatics, AChangedSeaComputesItsNewWavesAlone) {
    Parameters parameters = beach_sea();
    double delays = 0.0;  // the share of reports
    OceanOptions options;
    options.build_progress = [&](std::string_view work, double) {
        delays += work == "coast: delays" ? 1.0 : 0.0;
    };
    Ocean ocean(parameters, options);
    const Domain domain{{500.0, 100.0}, {300.0, 300.0}, {31, 31}, false};
    const auto reports_of = [&](double wind, double direction) {
        WaveSystem& waves = parameters.waves.front();
        waves.wind_speed = wind;
        waves.wind_direction = direction;
        delays = 0.0;
        ocean.change(Sea{parameters, {}});
        const Surface changed = ocean.region(4.0, domain, Channel::height);
        const double reports = delays;
        const Surface anew = Ocean(parameters).region(4.0, domain, Channel::height);
        EXPECT_TRUE(test::same_bits(changed, anew)) << wind << " m/s to " << direction;
        return reports;
    };
    const double all = reports_of(12.0, 0.0);
    ASSERT_GT(all, 20.0);
    const double a_sector = reports_of(12.0, 40.0);
    EXPECT_GT(a_sector, 0.0);
    EXPECT_LT(a_sector, 0.5 * all) << "two of three sectors are those of before";
    EXPECT_EQ(reports_of(12.0, 0.0), 0.0);
    EXPECT_GT(reports_of(9.0, 0.0), 0.5 * all) << "other bands";
    EXPECT_EQ(reports_of(12.0, 40.0), 0.0);
    // Delays do not depend on the swash.
    parameters.water.shore.swash = Swash::off;
    EXPECT_EQ(reports_of(12.0, 40.0), 0.0);
    // They depend on the depth of the open sea.
    parameters.water.depth = 21.0;
    EXPECT_GT(reports_of(12.0, 40.0), 0.5 * all);
}

TEST(ShoreStatics, AreAsLargeAsToldAndAtMost5500KilobytesForASquareKilometreAndSector) {
    const Parameters parameters =
        over_beach(test::coast_sea(128, 1024.0, 20.0), 251, 251, 4.0, 900.0);
    const SeaBed& ground = *parameters.water.bed;
    const BedGrid bed{ground.domain, {ground.heights.begin(), ground.heights.end()}};
    const DirectionalSpectrum spectrum = make_directional_spectrum(parameters);
    const ShoreBands bands = choose_bands(spectrum, parameters);
    const auto delays = make_shore_delays(bed, bands, parameters.water, test::pool());
    const auto energy = make_shore_energy(bed, *delays, spectrum, parameters.water, test::pool());
    std::size_t bytes = delays->ground.bytes() + energy->breaking.bytes() +
                        energy->remainder.bytes() + energy->lee.bytes();
    for (const BandSectorDelays& waves : delays->waves) bytes += waves.maps->bytes();
    for (const QuadGrid& amplitudes : energy->amplitudes) bytes += amplitudes.bytes();
    std::set<int> sectors;
    for (const ShoreWaves& waves : bands.waves) sectors.insert(waves.sector);
    ASSERT_GE(sectors.size(), 3u);
    EXPECT_LE(static_cast<double>(bytes) / static_cast<double>(sectors.size()), 5.5e6);
    EXPECT_LE(bytes, shore_statics_bytes(ground.domain, bands.waves.size()));
}

}  // namespace
}  // namespace ocean
