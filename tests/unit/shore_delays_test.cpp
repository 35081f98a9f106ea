// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Delays of waves over a bed: the affine maps keep the wave vectors of a whole sea over a rough
// bed, and deep water is left exactly as it is. Plane beaches are judged by the group coast of
// `ocean verify`.
#include "coast/statics/shore_delays.hpp"

#include <cstdint>
#include <exception>

#include "coast/statics/shore_land.hpp"
#include "shore_waves.hpp"
#include "test_seas.hpp"

namespace ocean {
namespace {

TEST(ShoreDelays, KeepWaveVectorsOverARoughBed) {
    // Each wave is compared with an eikonal solve of its own.
    const double cell = 4.0;
    const BedGrid bed = rough_bed(200, 160, cell);
    const BedGrid depth = felt_depth(bed, std::numeric_limits<double>::infinity());
    const SampleGrid grid = size_of(depth);
    const Water water = water_of_depth(std::numeric_limits<double>::infinity());
    const ShoreBands bands = bands_of_wind_sea({0, 1});
    const auto maps = shore_delays(depth, bands, water, test::pool());
    double sum[5] = {}, total[5] = {};
    for (const double omega : {0.7, 0.8, 0.85, 0.95, 1.15, 1.5, 2.1}) {
        for (const double angle : {-14.0, 2.0, 15.0, 30.0, 50.0}) {
            const double k = omega * omega / kGravity;
            int b = 0;
            while (k >= bands.edges[static_cast<std::size_t>(b + 1)]) ++b;
            const int sector = angle < 20.0 ? 0 : 1;
            OneWave wave(depth, k, angle * kDegree);
            wave.smooth();
            const DelayMaps& m = maps[static_cast<std::size_t>(sector * kShoreBands + b)];
            const double energy =
                omega * wind_sea(omega) * std::pow(std::cos(0.5 * (angle - 20.0) * kDegree), 20.0);
            for (const auto [i, j] : test::pairs({2, grid.columns - 2}, {2, grid.rows - 2})) {
                const double d = double{depth.at(i, j)};
                if (d < 1.0 || d > 16.0) continue;
                const int bin = d < 2.0 ? 0 : (d < 4.0 ? 1 : (d < 8.0 ? 2 : 3));
                const PlaneVector v =
                    mapped_wave(m, grid, cell, i, j, {k * wave.direction.x, k * wave.direction.y});
                const PlaneVector own = wave.wave(i, j);
                const double length = k * double{wave.slowness[grid.index(i, j)]};
                sum[bin] +=
                    energy * std::pow(std::hypot(v.x - k * own.x, v.y - k * own.y) / length, 2);
                total[bin] += energy;
            }
        }
    }
    for (int bin = 0; bin < 3; ++bin) {
        EXPECT_LE(std::sqrt(sum[bin] / total[bin]), 0.15) << "depth " << (1 << bin);
    }
}

// ---- Where nothing happens

std::vector<float> all_shifts(const std::vector<DelayMaps>& maps) {
    std::vector<float> all;
    for (const DelayMaps& m : maps) {
        for (const auto* map : {&m.shift_x, &m.shift_y, &m.phase}) {
            all.insert(all.end(), map->begin(), map->end());
        }
    }
    return all;
}

TEST(ShoreDelays, AreExactlyZeroOverTheOpenSeasOwnDepthAndThreePeakLengths) {
    const double three_lengths = 3.0 * kTwoPi / (0.857 * 0.857 / kGravity);
    struct Case {
        double bed, water;
    };
    for (const Case& c : {Case{20.0, 20.0}, Case{60.0, 60.0},
                          Case{three_lengths, std::numeric_limits<double>::infinity()}}) {
        const BedGrid bed = grid_of(40, 30, 5.3, [&](double, double) { return -c.bed; });
        const Water water = water_of_depth(c.water);
        const BedGrid depth = felt_depth(bed, water.depth);
        const auto maps = shore_delays(depth, bands_of_wind_sea({0, 1, 2, 3, 4, 5, 6, 7, 8}), water,
                                       test::pool());
        ASSERT_EQ(maps.size(), 36u);
        for (const float value : all_shifts(maps)) ASSERT_EQ(value, 0.0f) << c.bed;
        const double angle = sector_centre(2);
        for (std::size_t n = 0; n < maps[8].direction_x.size(); ++n) {
            ASSERT_NEAR(double{maps[8].direction_x[n]}, std::cos(angle), 1e-6);
            ASSERT_NEAR(double{maps[8].direction_y[n]}, std::sin(angle), 1e-6);
        }
    }
}

TEST(ShoreDelays, AreZeroInDeepWaterBeforeAnIslandAndNotBehind) {
    const BedGrid bed = grid_of(120, 100, 4.0, [](double x, double y) {
        return std::max(-30.0, 2.0 - 0.3 * std::hypot(x - 250.0, y - 200.0));
    });
    const Water water = water_of_depth(30.0);
    const auto maps =
        shore_delays(felt_depth(bed, 30.0), bands_of_wind_sea({0}), water, test::pool());
    const std::size_t before = 50 * 120 + 10, behind = 50 * 120 + 110;
    for (const DelayMaps& m : maps) {
        EXPECT_EQ(m.shift_x[before], 0.0f);
        EXPECT_EQ(m.phase[before], 0.0f);
        EXPECT_GT(std::abs(m.shift_x[behind]) + std::abs(m.phase[behind]), 0.01f);
    }
}

TEST(ShoreDelays, EndWithWhatProgressThrows) {
    struct Stop : std::exception {};
    int calls = 0;
    const auto stop = [&](double share) {
        ++calls;
        if (share > 0.3) throw Stop();
    };
    const BedGrid depth = islands();
    EXPECT_THROW(
        shore_delays(depth, bands_of_wind_sea({0, 1}), water_of_depth(40.0), test::pool(), stop),
        Stop);
    EXPECT_LT(calls, 10);
    EXPECT_TRUE(shore_delays(depth, ShoreBands{}, water_of_depth(40.0), test::pool()).empty());
}

TEST(FeltDepth, IsTheSmoothedBedWithinItsLimits) {
    // A ridge as narrow as a cell keeps the share of a Gaussian of 6 m, and of 1.5 cells at least.
    for (const double cell : {2.0, 4.0, 10.0}) {
        const double ridge = 31.0 * cell;
        const BedGrid bed =
            grid_of(64, 20, cell, [&](double x, double) { return x == ridge ? -10.0 : -20.0; });
        const BedGrid depth = felt_depth(bed, 100.0);
        const double deviation = std::max(6.0, 1.5 * cell);
        const double share = cell / (deviation * std::sqrt(kTwoPi));
        EXPECT_NEAR(double{depth.at(31, 10)}, 20.0 - 10.0 * share, 0.1 * 10.0 * share);
    }
    const BedGrid slope = grid_of(64, 20, 4.0, [](double x, double) { return x / 4.0 - 30.0; });
    const BedGrid depth = felt_depth(slope, 20.0);
    EXPECT_EQ(depth.at(0, 3), 20.0f);
    EXPECT_EQ(depth.at(63, 3), 0.6f);
    EXPECT_NEAR(double{depth.at(20, 3)}, 10.0, 1e-4);
    EXPECT_EQ(depth.domain, slope.domain);
}

// ---- Land

TEST(ShoreLand, DelaysChangeByThreeHundredthsPastTheLastWater) {
    // The shore lies across the grid's diagonal, so nearest water is in both directions.
    const BedGrid bed =
        grid_of(60, 60, 4.0, [](double x, double y) { return (x + y - 236.0) / 30.0; });
    const std::vector<std::uint32_t> nearest = nearest_water(bed, test::pool());
    DelayMaps maps;
    for (const auto [i, j] : test::pairs(60, 60)) {
        maps.shift_x.push_back(static_cast<float>(2 * i));
        maps.shift_y.push_back(static_cast<float>(i - 3 * j));
        maps.phase.push_back(static_cast<float>(j));
    }
    const DelayMaps own = maps;
    continue_onto_land(maps, bed, nearest);
    const SampleGrid grid = size_of(bed);
    for (const auto [i, j] : test::pairs(60, 60)) {
        const std::size_t at = grid.index(i, j);
        const auto w = std::size_t{nearest[at]};
        ASSERT_LE(bed.values[w], -0.4f);
        if (bed.values[at] <= -0.4f) {
            ASSERT_EQ(w, at);
            ASSERT_EQ(maps.shift_x[at], own.shift_x[at]);
            continue;
        }
        double least = 1e9;
        for (const auto [u, v] : test::pairs(60, 60)) {
            if (bed.at(u, v) <= -0.4f) least = std::min(least, std::hypot(u - i, v - j));
        }
        const int u = static_cast<int>(w) % 60, v = static_cast<int>(w) / 60;
        ASSERT_LE(std::hypot(u - i, v - j), least + 1.0) << "no other water is nearer by a cell";
        const double x = 4.0 * i + double{own.shift_x[at]}, xw = 4.0 * u + double{own.shift_x[w]};
        ASSERT_NEAR(4.0 * i + double{maps.shift_x[at]}, xw + 0.03 * (x - xw), 1e-3);
        const double y = 4.0 * j + double{own.shift_y[at]}, yw = 4.0 * v + double{own.shift_y[w]};
        ASSERT_NEAR(4.0 * j + double{maps.shift_y[at]}, yw + 0.03 * (y - yw), 1e-3);
        ASSERT_NEAR(double{maps.phase[at]},
                    double{own.phase[w]} + 0.03 * double{own.phase[at] - own.phase[w]}, 1e-4);
    }
}

TEST(ShoreLand, WaterAloneAndLandAloneAreTheirOwnNearest) {
    for (const double height : {-3.0, 3.0, -0.4}) {
        const BedGrid bed = grid_of(5, 4, 4.0, [&](double, double) { return height; });
        const auto nearest = nearest_water(bed, test::pool());
        for (std::size_t n = 0; n < nearest.size(); ++n) EXPECT_EQ(nearest[n], n);
    }
}

}  // namespace
}  // namespace ocean
