// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Gullies: every instruction set against the formulas of the shader, values that depend on the
// place alone, and the land that they make of smooth mountains.
#include "ocean/gullies.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "land/land.hpp"
#include "ocean/error.hpp"
#include "ocean/grid.hpp"
#include "ocean/land.hpp"
#include "ocean/thread_pool.hpp"
#include "terrain/gullies_task.hpp"

namespace ocean {
namespace {

constexpr std::size_t kValues = 6;

/// Places with their values: height, slope_x, slope_y, wear, gully, ridge.
struct Points {
    std::vector<double> x, y;
    std::array<std::vector<float>, kValues> value;

    explicit Points(std::size_t count = 0) { resize(count); }
    void resize(std::size_t count) {
        x.resize(count);
        y.resize(count);
        for (auto& values : value) values.assign(count, 0.0f);
    }
    std::size_t size() const { return x.size(); }
    GullyPoints spans() {
        return {x, y, value[0], value[1], value[2], value[3], value[4], value[5]};
    }
    GullyArrays arrays() {
        return {size(),          x.data(),        y.data(),        value[0].data(), value[1].data(),
                value[2].data(), value[3].data(), value[4].data(), value[5].data()};
    }
    std::array<std::uint32_t, kValues> bits(std::size_t p) const {
        std::array<std::uint32_t, kValues> result;
        for (std::size_t a = 0; a < kValues; ++a) {
            result[a] = std::bit_cast<std::uint32_t>(value[a][p]);
        }
        return result;
    }
};

/// Sets a smooth base of hills, 200 m high and kilometres apart, which repeats after 6100 m.
void set_hills(Points& points, std::size_t p) {
    const double kx = kTwoPi / 6100.0;
    const double ky = 2.0 * kTwoPi / 6100.0;
    const double a = kx * points.x[p] + ky * points.y[p];
    const double b = ky * points.x[p] - kx * points.y[p];
    points.value[0][p] = static_cast<float>(200.0 * (std::sin(a) + std::cos(b)));
    points.value[1][p] = static_cast<float>(200.0 * (kx * std::cos(a) - ky * std::sin(b)));
    points.value[2][p] = static_cast<float>(200.0 * (ky * std::cos(a) + kx * std::sin(b)));
}

Points random_hills(std::size_t count, double extent, unsigned seed) {
    Points points(count);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> place(-extent, extent);
    for (std::size_t p = 0; p < count; ++p) {
        points.x[p] = place(random);
        points.y[p] = place(random);
        set_hills(points, p);
    }
    return points;
}

std::vector<SimdLevel> levels() {
    std::vector<SimdLevel> result;
    for (const SimdLevel level :
         {SimdLevel::portable, SimdLevel::sse4, SimdLevel::avx2, SimdLevel::avx512}) {
        if (simd_available(level)) result.push_back(level);
    }
    return result;
}

// Runs the formulas of the shader for one point, in the precision of a namespace of land.hpp.
#define OCEAN_FORMULAS(precision, real)                                                        \
    std::array<real, kValues> precision##_formulas(const GullyFilter& filter, double cell,     \
                                                   const Points& points, std::size_t p) {      \
        namespace formulas = land::precision##_precision;                                      \
        const GullyTask task = make_gully_task(filter, cell);                                  \
        const formulas::GullyRule rule = {task.flat_square, task.roundness, task.mean,         \
                                          task.short_mean,  task.profile,   task.wear_scale};  \
        const real slope_x = points.value[1][p];                                               \
        const real slope_y = points.value[2][p];                                               \
        formulas::GullyState state = formulas::gully_begin(slope_x, slope_y);                  \
        for (int o = 0; o < task.octaves; ++o) {                                               \
            const GullyOctaveTask& octave = task.octave[o];                                    \
            const GullyOctave& lattice = filter.octaves()[static_cast<std::size_t>(o)];        \
            const GullyLatticePoint x = nearest_lattice_point(lattice, points.x[p]);           \
            const GullyLatticePoint y = nearest_lattice_point(lattice, points.y[p]);           \
            state = formulas::gully_octave(                                                    \
                state, rule,                                                                   \
                {octave.height, octave.steepness, octave.weight, octave.key, octave.last},     \
                {x.index, y.index, static_cast<real>(x.offset), static_cast<real>(y.offset)}); \
        }                                                                                      \
        return {static_cast<real>(points.value[0][p]) + state.height,                          \
                formulas::gully_slope(slope_x, state.slope_x),                                 \
                formulas::gully_slope(slope_y, state.slope_y),                                 \
                rule.wear_scale * state.wear,                                                  \
                real(1) - state.no_gully,                                                      \
                real(1) - state.no_ridge};                                                     \
    }
OCEAN_FORMULAS(single, float)
OCEAN_FORMULAS(double, double)
#undef OCEAN_FORMULAS

TEST(Gullies, EveryInstructionSetHasTheBitsOfTheFormulas) {
    for (const double period : {0.0, 6100.0}) {
        const GullyFilter filter({.period = period});
        for (const double cell : {0.0, 20.0}) {
            const GullyTask task = make_gully_task(filter, cell);
            for (const SimdLevel level : levels()) {
                const auto loop = gully_loop(level);
                for (const std::size_t count : {1u, 3u, 4u, 7u, 15u, 16u, 17u, 300u}) {
                    const Points before = random_hills(count, 1e7, 5u + unsigned(count));
                    Points after = before;
                    loop(task, after.arrays());
                    for (std::size_t p = 0; p < count; ++p) {
                        const auto expected = single_formulas(filter, cell, before, p);
                        for (std::size_t a = 0; a < kValues; ++a) {
                            ASSERT_EQ(after.value[a][p], expected[a])
                                << simd_name(level) << ' ' << a << " of point " << p;
                        }
                    }
                }
            }
        }
    }
}

TEST(Gullies, FloatIsAsGoodAsDouble) {
    const GullyFilter filter({});
    const Points before = random_hills(5000, 1e7, 9);
    std::array<double, kValues> worst{};
    for (std::size_t p = 0; p < before.size(); ++p) {
        const auto single = single_formulas(filter, 0.0, before, p);
        const auto exact = double_formulas(filter, 0.0, before, p);
        for (std::size_t a = 0; a < kValues; ++a) {
            worst[a] = std::max(worst[a], std::abs(static_cast<double>(single[a]) - exact[a]));
        }
    }
    EXPECT_LT(worst[0], 3e-4);  // [m]
    for (std::size_t a = 1; a < kValues; ++a) EXPECT_LT(worst[a], 1e-5) << a;
}

TEST(Gullies, TheHashHas32Bits) {
    // By Python's integers, masked to 32 bits.
    EXPECT_EQ(land::single_precision::gully_hash(0x00000001u), 0x688990C0u);
    EXPECT_EQ(land::single_precision::gully_hash(0xFFFFFFFFu), 0x6768824Au);
    EXPECT_EQ(land::single_precision::gully_hash(0x9E3779B9u), 0x01FCE552u);
}

TEST(Gullies, EachSeedAndOctaveHasAKeyOfItsOwn) {
    std::set<std::uint32_t> keys;
    for (std::uint32_t seed = 0; seed < 100; ++seed) {
        const GullyFilter filter({.octaves = kMaxGullyOctaves, .seed = seed});
        for (const GullyOctave& octave : filter.octaves()) keys.insert(octave.key);
    }
    EXPECT_EQ(keys.size(), 100u * kMaxGullyOctaves);
}

TEST(Gullies, TheSineIsOneOfTurns) {
    for (int i = -1000; i <= 1000; ++i) {
        const float turns = 0.25f * static_cast<float>(i) / 1000.0f;
        EXPECT_NEAR(land::single_precision::gully_sine(turns),
                    std::sin(kTwoPi * static_cast<double>(turns)), 3e-7);
    }
}

TEST(Gullies, LatticePointsCountPlacesUpToTenThousandKilometres) {
    for (const double period : {0.0, 6100.0}) {
        const GullyFilter filter({.period = period});
        for (const GullyOctave& octave : filter.octaves()) {
            for (const double place : {0.0, -1e-9, 1234.5, -6100.0, 9999999.7, -9999999.9}) {
                const GullyLatticePoint point = nearest_lattice_point(octave, place);
                const double at = place / octave.wavelength;
                EXPECT_LE(std::abs(point.offset), 0.5);
                double index =
                    octave.count > 0 ? point.index : static_cast<double>(std::int32_t(point.index));
                if (octave.count > 0) {
                    EXPECT_LT(point.index, octave.count);
                    index += octave.count * std::round((at - index) / octave.count);
                }
                EXPECT_NEAR(index + point.offset, at, 1e-9);
            }
        }
    }
}

TEST(Gullies, ChunksOfAnyOriginSizeAndOrderShareTheirBits) {
    constexpr double kCell = 7.3;
    const GullyFilter filter({});
    // Places are counted in cells of the whole land; each region computes its own points.
    const auto region = [&](int i0, int j0, int width, int height, bool backwards) {
        Points points(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
        for (int j = 0; j < height; ++j) {
            for (int i = 0; i < width; ++i) {
                auto p = static_cast<std::size_t>(j * width + i);
                if (backwards) p = points.size() - 1 - p;
                points.x[p] = kCell * (i0 + i);
                points.y[p] = kCell * (j0 + j);
                set_hills(points, p);
            }
        }
        filter.apply(points.spans(), kCell);
        return points;
    };
    std::mt19937 random(3);
    const auto below = [&](int n) { return static_cast<int>(random() % unsigned(n)); };
    for (int test = 0; test < 200; ++test) {
        const int i = below(2000000) - 1000000;
        const int j = below(2000000) - 1000000;
        const int width = 1 + below(13), height = 1 + below(5);
        const int di = below(width), dj = below(height);
        const bool backwards = below(2) == 1;
        const Points alone = region(i, j, 1, 1, false);
        const Points many = region(i - di, j - dj, width, height, backwards);
        auto p = static_cast<std::size_t>(dj * width + di);
        if (backwards) p = many.size() - 1 - p;
        ASSERT_EQ(alone.bits(0), many.bits(p)) << test;
    }
}

TEST(Gullies, ThreadsShareAFilter) {
    const GullyFilter filter({});
    const Points before = random_hills(3001, 1e5, 21);
    Points whole = before;
    filter.apply(whole.spans(), 0.0);
    Points shares = before;
    ThreadPool pool(3);
    pool.for_each_range(static_cast<int>(before.size()), [&](int first, int last) {
        const auto from = static_cast<std::size_t>(first);
        const auto count = static_cast<std::size_t>(last - first);
        const GullyPoints all = shares.spans();
        filter.apply({all.x.subspan(from, count), all.y.subspan(from, count),
                      all.height.subspan(from, count), all.slope_x.subspan(from, count),
                      all.slope_y.subspan(from, count), all.wear.subspan(from, count),
                      all.gully.subspan(from, count), all.ridge.subspan(from, count)},
                     0.0);
    });
    for (std::size_t p = 0; p < before.size(); ++p) ASSERT_EQ(whole.bits(p), shares.bits(p));
}

TEST(Gullies, RepeatExactlyWithThePeriod) {
    // 6100 / 1500 and its doubles are no whole numbers: 4, 8, 16, 33, 65 and 130 points.
    const GullyFilter filter({.period = 6100.0});
    EXPECT_EQ(filter.octaves()[3].count, 33u);
    EXPECT_EQ(filter.octaves()[4].count, 65u);
    EXPECT_NEAR(filter.octaves()[4].wavelength * 65.0, 6100.0, 1e-9);
    Points here = random_hills(4000, 6100.0, 11);
    Points there = here;
    for (std::size_t p = 0; p < here.size(); ++p) {
        there.x[p] += 6100.0 * static_cast<double>(static_cast<int>(p % 5) - 2);
        there.y[p] += 6100.0 * static_cast<double>(static_cast<int>(p % 7) - 3);
    }
    Points other = there;
    filter.apply(here.spans(), 0.0);
    filter.apply(there.spans(), 0.0);
    GullyFilter({}).apply(other.spans(), 0.0);
    double most = 0.0;
    int differ = 0;
    for (std::size_t p = 0; p < here.size(); ++p) {
        const double height = static_cast<double>(here.value[0][p]);
        most = std::max(most, std::abs(static_cast<double>(there.value[0][p]) - height));
        if (std::abs(static_cast<double>(other.value[0][p]) - height) > 1.0) ++differ;
    }
    EXPECT_LT(most, 1e-3);  // [m], from the last digit of offsets and slopes
    EXPECT_GT(differ, 3000);
}

TEST(Gullies, AreContinuousWhereTheNearestLatticePointChanges) {
    for (const double period : {0.0, 6100.0}) {
        const GullyFilter filter({.octaves = 1, .period = period});
        const double spacing = filter.octaves()[0].wavelength;
        // On both sides of the lines between lattice points, through two periods.
        Points points(2 * 2 * 9 * 50);
        for (std::size_t p = 0; p < points.size(); ++p) {
            const std::size_t line = p / 2 % 9, place = p / 36;
            const double at = spacing * (static_cast<double>(line) - 4.5);
            const double along = 173.0 * static_cast<double>(place) - 4000.0;
            const double beside = at + (p % 2 == 0 ? 1e-6 : -1e-6);
            points.x[p] = p / 18 % 2 == 0 ? beside : along;
            points.y[p] = p / 18 % 2 == 0 ? along : beside;
            points.value[1][p] = 0.2f;
            points.value[2][p] = 0.3f;
        }
        filter.apply(points.spans(), 0.0);
        for (std::size_t p = 0; p < points.size(); p += 2) {
            ASSERT_NEAR(points.value[0][p], points.value[0][p + 1], 1e-3) << p;
        }
    }
}

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
        RecordProperty("ratio_" + std::to_string(static_cast<int>(degrees)), std::to_string(ratio));
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

TEST(Gullies, RefuseValuesOutOfTheirRanges) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const GullySettings& settings :
         {GullySettings{.longest = 0.0}, GullySettings{.longest = nan}, GullySettings{.octaves = 0},
          GullySettings{.octaves = kMaxGullyOctaves + 1}, GullySettings{.depth = -0.1},
          GullySettings{.crease = 1.1}, GullySettings{.flat = 0.0}, GullySettings{.period = 5999.0},
          GullySettings{.period = 1e12}}) {
        EXPECT_THROW(GullyFilter{settings}, Error);
    }
    EXPECT_NO_THROW(GullyFilter({.octaves = kMaxGullyOctaves, .period = 6000.0}));
    const GullyFilter filter({});
    Points points = random_hills(5, 1e4, 1);
    EXPECT_THROW(filter.apply(points.spans(), -1.0), Error);
    EXPECT_THROW(filter.apply(points.spans(), nan), Error);
    GullyPoints spans = points.spans();
    spans.slope_y = spans.slope_y.first(4);
    EXPECT_THROW(filter.apply(spans, 0.0), Error);
    spans = points.spans();
    spans.ridge = spans.ridge.first(4);
    EXPECT_THROW(filter.apply(spans, 0.0), Error);
    filter.apply({}, 0.0);
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
        Terrain terrain;
        terrain.resolution = resolution;
        terrain.patch_size = patch_size;
        terrain.beta = 1.8;
        terrain.outer_scale = 22000.0;
        terrain.breaks = {{3500.0, 3.6}, {60.0, 2.0}};
        terrain.rms = 560.0;
        const Surface map =
            Land(terrain).surface({Channel::height, Channel::slope_x, Channel::slope_y});
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
        double sum = 0.0;
        for (const float value : points.value[0]) sum += static_cast<double>(value);
        return sum / static_cast<double>(points.size());
    }
    /// Returns the slopes that 50, 90 and 99 % do not exceed [degrees], by central differences.
    std::array<double, 3> steepness() const {
        std::vector<double> slopes;
        for (int j = 1; j + 1 < side; ++j) {
            for (int i = 1; i + 1 < side; ++i) {
                const double x = (height(i + 1, j) - height(i - 1, j)) / (2.0 * step);
                const double y = (height(i, j + 1) - height(i, j - 1)) / (2.0 * step);
                slopes.push_back(std::hypot(x, y));
            }
        }
        std::array<double, 3> result{};
        const double parts[] = {0.5, 0.9, 0.99};
        for (std::size_t a = 0; a < 3; ++a) {
            const auto middle = slopes.begin() + static_cast<std::ptrdiff_t>(
                                                     parts[a] * static_cast<double>(slopes.size()));
            std::nth_element(slopes.begin(), middle, slopes.end());
            result[a] = std::atan(*middle) * 360.0 / kTwoPi;
        }
        return result;
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
    const double pits_before = land.pits(2);
    GullyFilter({}).apply(land.points.spans(), 0.0);
    const auto after = land.steepness();
    EXPECT_NEAR(before[1], 25.2, 1.0);
    EXPECT_NEAR(after[0], 20.9, 1.5);
    EXPECT_NEAR(after[1], 33.3, 1.5);
    EXPECT_NEAR(after[2], 43.0, 2.0);
    EXPECT_LT(pits_before, 0.3);
    EXPECT_LT(land.pits(2), 3.5);  // fewer than a rounded elevation model has
    for (std::size_t a = 0; a < 3; ++a) {
        RecordProperty("slope" + std::to_string(a),
                       std::to_string(before[a]) + " " + std::to_string(after[a]));
    }
    RecordProperty("pits", std::to_string(pits_before) + " " + std::to_string(land.pits(2)));
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
    RecordProperty("mean", std::to_string(sum / kSeeds));
}

}  // namespace
}  // namespace ocean
