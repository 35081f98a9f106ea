// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The shape of gullies, and the land that they make of smooth mountains.
#include "ocean/internal/gullies.hpp"

#include "gully_points.hpp"
#include "ocean/terrain.hpp"
#include "test_seas.hpp"

namespace ocean {
namespace {

using test::kValues;
using test::Points;
using test::random_hills;

TEST(Gullies, StripesFollowTheFallLine) {
    const GullyFilter filter({.octaves = 1});
    for (const double degrees : {0.0, 90.0, 200.0}) {
        // Each place with one 10 m farther down the slope and one 10 m across it.
        const double cosine = std::cos(degrees * kTwoPi / 360.0);
        const double sine = std::sin(degrees * kTwoPi / 360.0);
        Points points = random_hills(60000, 1e5, 4);
        for (std::size_t p = 0; p < points.size(); ++p) {
            const std::size_t first = p - p % 3;
            if (p % 3 == 1) {
                points.x[p] = points.x[first] + 10.0 * cosine;
                points.y[p] = points.y[first] + 10.0 * sine;
            } else if (p % 3 == 2) {
                points.x[p] = points.x[first] - 10.0 * sine;
                points.y[p] = points.y[first] + 10.0 * cosine;
            }
            points.value[0][p] = 0.0f;
            points.value[1][p] = static_cast<float>(0.3 * cosine);
            points.value[2][p] = static_cast<float>(0.3 * sine);
        }
        filter.apply(points.spans(), 0.0);
        double down = 0.0, across = 0.0;
        for (std::size_t p = 0; p < points.size(); p += 3) {
            const auto height = [&](std::size_t q) {
                return static_cast<double>(points.value[0][p + q]);
            };
            down += std::pow(height(1) - height(0), 2);
            across += std::pow(height(2) - height(0), 2);
        }
        const double ratio = std::sqrt(across / down);
        EXPECT_GT(ratio, 2.9) << degrees;
    }
}

TEST(Gullies, LeaveFlatsAlone) {
    Points points = random_hills(100, 1e4, 2);
    for (std::size_t a = 1; a < 3; ++a) points.value[a].assign(points.size(), 0.0f);
    const std::vector<float> height = points.value[0];
    GullyFilter({}).apply(points.spans(), 0.0);
    EXPECT_EQ(points.value[0], height);
    for (std::size_t a = 1; a < kValues; ++a) {
        for (const float value : points.value[a]) EXPECT_EQ(value, 0.0f);
    }
}

TEST(Gullies, OctavesFadeOutBetweenFourAndTwoCells) {
    EXPECT_EQ(gully_share(100.0, 0.0), 1.0);
    EXPECT_EQ(gully_share(100.0, 25.0), 1.0);
    EXPECT_NEAR(gully_share(120.0, 40.0), 0.5, 1e-12);
    EXPECT_EQ(gully_share(100.0, 50.0), 0.0);
    EXPECT_EQ(gully_share(100.0, 1e9), 0.0);
    // The ends are reached without a kink.
    EXPECT_NEAR(gully_share(100.0, 25.0 * 1.001), 1.0, 2e-5);
    EXPECT_NEAR(gully_share(100.0, 50.0 / 1.001), 0.0, 2e-5);

    const GullyFilter filter({.octaves = 4});  // 1500 .. 187.5 m
    const Points before = random_hills(500, 1e5, 6);
    const auto at = [&](double cell) {
        Points points = before;
        filter.apply(points.spans(), cell);
        return points.value[0];
    };
    EXPECT_EQ(at(46.0), at(0.0));
    EXPECT_EQ(at(750.0), before.value[0]);
    // Three octaves are left where the fourth has no share.
    Points three = before;
    GullyFilter({.octaves = 3}).apply(three.spans(), 0.0);
    EXPECT_EQ(at(93.75), three.value[0]);
    for (const double cell : {46.9, 62.49, 93.7, 124.98, 700.0}) {
        const auto a = at(cell), b = at(1.0005 * cell);
        for (std::size_t p = 0; p < a.size(); ++p) EXPECT_NEAR(a[p], b[p], 0.05) << cell;
    }
}

TEST(Gullies, MasksTellRidgesFromFloors) {
    Points points = random_hills(20000, 1e5, 8);
    const std::vector<float> base = points.value[0];
    GullyFilter({}).apply(points.spans(), 0.0);
    double on_ridges = 0.0, ridges = 0.0, on_floors = 0.0, floors = 0.0;
    for (std::size_t p = 0; p < points.size(); ++p) {
        const double added = static_cast<double>(points.value[0][p] - base[p]);
        const auto [wear, gully, ridge] =
            std::array{points.value[3][p], points.value[4][p], points.value[5][p]};
        ASSERT_TRUE(wear >= -1.0f && wear <= 1.0f);
        ASSERT_TRUE(gully >= 0.0f && gully <= 1.0f);
        ASSERT_TRUE(ridge >= 0.0f && ridge <= 1.0f);
        on_ridges += static_cast<double>(ridge) * added;
        ridges += static_cast<double>(ridge);
        on_floors += static_cast<double>(gully) * added;
        floors += static_cast<double>(gully);
    }
    EXPECT_GT(on_ridges / ridges, 20.0);  // [m]
    EXPECT_LT(on_floors / floors, -10.0);
    // Masks are optional.
    Points bare = random_hills(20000, 1e5, 8);
    GullyPoints spans = bare.spans();
    spans.wear = spans.gully = spans.ridge = {};
    GullyFilter({}).apply(spans, 0.0);
    EXPECT_EQ(bare.value[0], points.value[0]);
    EXPECT_EQ(bare.value[3], std::vector<float>(bare.size(), 0.0f));
}

TEST(Gullies, TheMeanOfTheCreaseIsThatOfAPhase) {
    for (const double crease : {0.0, 0.7, 1.0}) {
        const double e = 0.03 + 0.6 * (1.0 - crease);
        for (const double length : {0.0, 0.5, 1.0}) {
            double sum = 0.0;
            constexpr int kPhases = 4096;
            for (int i = 0; i < kPhases; ++i) {
                const double c = length * std::cos(kTwoPi * (i + 0.5) / kPhases);
                sum += 1.0 - 2.0 * (std::sqrt(0.5 * (1.0 - c) + e * e) - e);
            }
            EXPECT_NEAR(gully_crease_mean(crease, length), sum / kPhases, 1e-13);
        }
    }
}

// ---- The land that gullies make.

/// Mountains without short waves, as samples of a tile, scaled to a median slope of 14.5 degrees.
struct Mountains {
    Points points;
    int side;
    double step;  // [m]

    Mountains(int resolution, double patch_size)
        : points(static_cast<std::size_t>(resolution) * static_cast<std::size_t>(resolution)),
          side(resolution),
          step(patch_size / resolution) {
        TerrainModel terrain;
        terrain.resolution = resolution;
        terrain.patch_size = patch_size;
        terrain.beta = 1.8;
        terrain.outer_scale = 22000.0;
        terrain.breaks = {{3500.0, 3.6}, {60.0, 2.0}};
        terrain.rms = 560.0;
        const Surface map =
            Terrain(terrain).surface({Channel::height, Channel::slope_x, Channel::slope_y});
        const Channel channels[] = {Channel::height, Channel::slope_x, Channel::slope_y};
        for (std::size_t a = 0; a < 3; ++a) {
            const auto values = map.channel(channels[a]);
            points.value[a].assign(values.begin(), values.end());
        }
        const float gain = static_cast<float>(std::tan(14.5 * kTwoPi / 360.0) /
                                              std::tan(steepness()[0] * kTwoPi / 360.0));
        for (std::size_t a = 0; a < 3; ++a) {
            for (float& value : points.value[a]) value *= gain;
        }
        for (std::size_t p = 0; p < points.size(); ++p) {
            points.x[p] = step * static_cast<double>(p % static_cast<std::size_t>(side));
            points.y[p] = step * static_cast<double>(p / static_cast<std::size_t>(side));
        }
    }
    double height(int i, int j) const {
        return static_cast<double>(points.value[0][static_cast<std::size_t>(j * side + i)]);
    }
    double mean() const {
        const auto& heights = points.value[0];
        return std::accumulate(heights.begin(), heights.end(), 0.0) /
               static_cast<double>(heights.size());
    }
    /// Returns the slopes that 50, 90 and 99 % do not exceed [degrees], by central differences.
    std::array<double, 3> steepness() const {
        std::vector<double> slopes;
        for (const auto [i, j] : test::pairs({1, side - 1}, {1, side - 1})) {
            const double x = (height(i + 1, j) - height(i - 1, j)) / (2.0 * step);
            const double y = (height(i, j + 1) - height(i, j - 1)) / (2.0 * step);
            slopes.push_back(std::hypot(x, y));
        }
        return test::slope_angles(slopes);
    }
    /// Returns the hollows a km^2 of every n-th sample: no neighbour is lower.
    double pits(int n) const {
        int count = 0;
        for (int j = n; j + n < side; j += n) {
            for (int i = n; i + n < side; i += n) {
                bool lowest = true;
                for (int d = 0; d < 9; ++d) {
                    lowest =
                        lowest && height(i + n * (d % 3 - 1), j + n * (d / 3 - 1)) >= height(i, j);
                }
                if (lowest) ++count;
            }
        }
        return count / std::pow(1e-3 * step * side, 2);
    }
};

TEST(Gullies, SmoothMountainsBecomeAsSteepAsRealOnes) {
    Mountains land(1024, 14336.0);
    const auto before = land.steepness();
    EXPECT_LT(land.pits(2), 0.3);
    GullyFilter({}).apply(land.points.spans(), 0.0);
    const auto after = land.steepness();
    EXPECT_NEAR(before[1], 25.2, 1.0);
    EXPECT_NEAR(after[0], 20.9, 1.5);
    EXPECT_NEAR(after[1], 33.3, 1.5);
    EXPECT_NEAR(after[2], 43.0, 2.0);
    EXPECT_LT(land.pits(2), 3.5);  // fewer than a rounded elevation model has
}

TEST(Gullies, MoveNoMeanHeight) {
    const Mountains base(256, 28672.0);
    const double before = base.mean();
    double sum = 0.0;
    constexpr unsigned kSeeds = 16;
    for (unsigned seed = 1; seed <= kSeeds; ++seed) {
        Mountains land = base;
        GullyFilter({.seed = seed}).apply(land.points.spans(), 0.0);
        EXPECT_NEAR(land.mean(), before, 1.5);  // chance of the octave of 1500 m
        sum += land.mean() - before;
    }
    EXPECT_NEAR(sum / kSeeds, 0.0, 0.35);
}

}  // namespace
}  // namespace ocean
