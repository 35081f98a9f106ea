// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Gullies as values of places: every instruction set against the formulas of the shader, and bits
// that depend on the place alone.
#include "ocean/internal/gullies.hpp"

#include <set>

#include "gully_points.hpp"
#include "land/land.hpp"
#include "ocean/error.hpp"
#include "ocean/thread_pool.hpp"
#include "simd_levels.hpp"
#include "test_seas.hpp"

namespace ocean {
namespace {

using test::GullyLatticePoint;
using test::kValues;
using test::levels;
using test::nearest_lattice_point;
using test::Points;
using test::random_hills;
using test::set_hills;

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
        for (const auto [i, j, at] : test::cells(width, height)) {
            auto p = at;
            if (backwards) p = points.size() - 1 - p;
            points.x[p] = kCell * (i0 + i);
            points.y[p] = kCell * (j0 + j);
            set_hills(points, p);
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

}  // namespace
}  // namespace ocean
