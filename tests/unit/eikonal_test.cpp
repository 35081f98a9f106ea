// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// One wave over a bed: its slowness is that of the dispersion relation, its direction obeys Snell's
// law up to the border of the bed, and lees are solved to the end.

#include "shore_waves.hpp"

namespace ocean {
namespace {

// ---- Slowness

TEST(Slowness, IsThatOfTheDispersionRelationAndOneInTheOpenSea) {
    for (const double depth : {20.0, 60.0, std::numeric_limits<double>::infinity()}) {
        const Water water = water_of_depth(depth);
        for (const double k : {0.02, 0.075, 0.4, 1.6}) {
            const Slowness slowness(k, water, 0.6);
            const double omega = Dispersion(water).angular_frequency(k);
            EXPECT_EQ(slowness.at(depth), 1.0f);
            EXPECT_EQ(slowness.at(5.0 / k + 1.0), 1.0f) << k;
            for (double d = 0.6; d < std::min(depth, 4.0 / k); d *= 1.03) {
                const double true_value = wavenumber(omega, d) / k;
                // The table is linear between 1024 entries; at 4 / k the threshold has ended.
                EXPECT_NEAR(double{slowness.at(d)} / true_value, 1.0,
                            true_value > 1.0004 ? 2e-4 : 4e-4)
                    << k << " " << d;
            }
        }
    }
}

// ---- One wave

TEST(Eikonal, ObeysSnellsLawOnABeachOfAnyDirectionUpToTheBorder) {
    // The bound is half a degree. The beach falls along x, then at angles to the grid, where all
    // four borders cross its contours, and where even the deepest border is shallow.
    struct Case {
        double deepest, beach, wave;
    };
    for (const Case& c :
         {Case{36.0, 0.0, 20.0}, Case{36.0, 0.0, -20.0}, Case{36.0, 30.0, 50.0},
          Case{36.0, -140.0, -160.0}, Case{8.0, 0.0, 20.0}, Case{8.0, 60.0, 40.0}}) {
        const double ux = std::cos(c.beach * kDegree), uy = std::sin(c.beach * kDegree);
        const int columns = 300, rows = 140;
        const auto along = [&](double x, double y) {
            return ux * (x - (ux < 0.0 ? 4.0 * (columns - 1) : 0.0)) +
                   uy * (y - (uy < 0.0 ? 4.0 * (rows - 1) : 0.0));
        };
        const BedGrid depth = grid_of(columns, rows, 4.0, [&](double x, double y) {
            return std::max(c.deepest - along(x, y) / 30.0, 0.6);
        });
        const double k = 0.857 * 0.857 / kGravity;
        const OneWave wave(depth, k, c.wave * kDegree);
        double worst = 0.0, longest = 0.0;
        for (const auto [i, j] : test::pairs({1, columns - 1}, {1, rows - 1})) {
            if (depth.at(i, j) < 0.7f) continue;
            const double s = double{wave.slowness[wave.grid.index(i, j)]};
            const double expected =
                c.beach * kDegree + std::asin(std::sin((c.wave - c.beach) * kDegree) / s);
            const PlaneVector v = wave.wave(i, j);
            const double error =
                std::abs(std::remainder(std::atan2(v.y, v.x) - expected, kTwoPi)) / kDegree;
            worst = std::max(worst, error);
            // A scheme of first order is off by half a cell: here 3 % at a depth of 1 m.
            longest = std::max(longest, std::abs(std::hypot(v.x, v.y) / s - 1.0));
        }
        EXPECT_LE(longest, 0.015) << "depth " << c.deepest << ", beach " << c.beach;
        EXPECT_LE(worst, 0.5) << "depth " << c.deepest << ", beach " << c.beach;
    }
}

/// Returns by how much the steepest descent to neighbours exceeds the slowness around a sample at
/// most: where a wave could arrive earlier, it does.
double excess(const OneWave& wave) {
    double worst = -1.0;
    const SampleGrid& grid = wave.grid;
    for (int j = 1; j + 1 < grid.rows; ++j) {
        for (int i = 1; i + 1 < grid.columns; ++i) {
            const auto fall = [&](int di, int dj) {
                return wave.delay[grid.index(i, j)] - wave.delay[grid.index(i + di, j + dj)] -
                       (wave.direction.x * di + wave.direction.y * dj);
            };
            const double x = std::max({fall(-1, 0), fall(1, 0), 0.0});
            const double y = std::max({fall(0, -1), fall(0, 1), 0.0});
            float slowest = 0.0f;
            for (const int n : {-1, 0, 1}) {
                slowest = std::max({slowest, wave.slowness[grid.index(i + n, j)],
                                    wave.slowness[grid.index(i, j + n)]});
            }
            worst = std::max(worst, std::hypot(x, y) - double{slowest});
        }
    }
    return worst;
}

TEST(Eikonal, EndsWithAllSweepsDoneWhereFourLeaveLongDelays) {
    const BedGrid depth = islands();
    for (const double angle : {20.0, 100.0, 250.0}) {
        const OneWave wave(depth, 0.075, angle * kDegree);
        const OneWave four(depth, 0.075, angle * kDegree, 4);
        const OneWave all(depth, 0.075, angle * kDegree, 1000);
        const double cell = 4.0;
        double error = 0.0, error_of_four = 0.0;
        for (std::size_t n = 0; n < all.delay.size(); ++n) {
            error = std::max(error, std::abs(wave.delay[n] - all.delay[n]));
            error_of_four = std::max(error_of_four, std::abs(four.delay[n] - all.delay[n]));
        }
        EXPECT_EQ(error, 0.0) << angle;
        EXPECT_GE(cell * error_of_four, 5.0) << "four sweeps leave delays of a wave's length";
        EXPECT_LT(all.sweeps, 40) << "the sweeps end by themselves";
    }
}

TEST(Eikonal, LeavesNoSampleOfARoughBedThatCouldBeReachedEarlier) {
    BedGrid depth = rough_bed(200, 160, 4.0);
    for (float& value : depth.values) value = std::max(-value, 0.6f);
    for (const double angle : {20.0, 130.0, 250.0}) {
        const OneWave wave(depth, 0.0206, angle * kDegree);
        EXPECT_LE(excess(wave), 1e-5) << angle;
        EXPECT_GT(wave.sweeps, 12) << "a bed that needs many";
    }
}

}  // namespace
}  // namespace ocean
