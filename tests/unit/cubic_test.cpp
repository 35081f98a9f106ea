// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The kernels that maps are read by, and the polynomials that ease from 0 to 1.
#include "field/cubic.hpp"

#include <cstddef>

#include "field/bilinear.hpp"
#include "field/ease.hpp"
#include "testing.hpp"

namespace ocean {
namespace {

template <typename Real>
Real sum(const std::array<Real, 4>& numbers) {
    return std::accumulate(numbers.begin(), numbers.end(), Real(0));
}

/// Calls check(t) at places from one end of a cell to the other.
template <typename Check>
void across_a_cell(const Check& check) {
    for (int n = 0; n <= 64; ++n) check(n / 64.0);
}

TEST(Cubic, WeightsSumToOneAndTheirDerivativesToZero) {
    across_a_cell([](double t) {
        const auto place = static_cast<float>(t);
        EXPECT_NEAR(sum(b_spline(t)), 1.0, 1e-15) << t;
        EXPECT_NEAR(sum(b_spline_slopes(t)), 0.0, 1e-15) << t;
        EXPECT_NEAR(sum(b_spline(place)), 1.0f, 3e-7f) << t;
        EXPECT_NEAR(sum(b_spline_slopes(place)), 0.0f, 3e-7f) << t;
        EXPECT_NEAR(sum(catmull_rom(place)), 1.0f, 3e-7f) << t;
        EXPECT_NEAR(sum(catmull_rom_slopes(place)), 0.0f, 6e-7f) << t;
    });
}

TEST(Cubic, TheBSplineIsTheSameInFloatsDoublesAndPolynomials) {
    across_a_cell([](double t) {
        const std::array<double, 4> weights = b_spline(t), slopes = b_spline_slopes(t);
        const auto place = static_cast<float>(t);
        for (std::size_t i = 0; i < 4; ++i) {
            EXPECT_NEAR(b_spline(place)[i], weights[i], 2e-7) << t;
            EXPECT_NEAR(b_spline_slopes(place)[i], slopes[i], 2e-7) << t;
            const auto power = [&](std::size_t n) { return double{kBSpline[n][i]}; };
            EXPECT_NEAR(power(0) + t * (power(1) + t * (power(2) + t * power(3))), weights[i], 1e-7)
                << t;
            EXPECT_NEAR(power(1) + t * (2.0 * power(2) + t * 3.0 * power(3)), slopes[i], 1e-7) << t;
        }
    });
}

TEST(Cubic, SlopesAreTheDerivativesOfTheWeights) {
    constexpr double kStep = 1.0 / 1024.0;
    for (double t = kStep; t < 1.0; t += 16.0 * kStep) {
        const auto before = static_cast<float>(t - kStep), after = static_cast<float>(t + kStep);
        for (std::size_t i = 0; i < 4; ++i) {
            const double spline = (b_spline(t + kStep)[i] - b_spline(t - kStep)[i]) / (2.0 * kStep);
            EXPECT_NEAR(b_spline_slopes(t)[i], spline, 2e-6) << t;
            const double cubic = double{catmull_rom(after)[i] - catmull_rom(before)[i]};
            EXPECT_NEAR(catmull_rom_slopes(static_cast<float>(t))[i], cubic / (2.0 * kStep), 1e-4)
                << t;
        }
    }
}

TEST(Cubic, CatmullRomPassesThroughTheSamplesWithTheirCentralSlope) {
    using Weights = std::array<float, 4>;
    EXPECT_EQ(catmull_rom(0.0f), (Weights{0.0f, 1.0f, 0.0f, 0.0f}));
    EXPECT_EQ(catmull_rom(1.0f), (Weights{0.0f, 0.0f, 1.0f, 0.0f}));
    EXPECT_EQ(catmull_rom_slopes(0.0f), (Weights{-0.5f, 0.0f, 0.5f, 0.0f}));
    EXPECT_EQ(catmull_rom_slopes(1.0f), (Weights{0.0f, -0.5f, 0.0f, 0.5f}));
}

TEST(Cubic, TheBSplineContinuesIntoTheNextCellWithItsSlope) {
    const std::array<double, 4> end = b_spline(1.0), begin = b_spline(0.0);
    const std::array<double, 4> end_slope = b_spline_slopes(1.0), slope = b_spline_slopes(0.0);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(end[i + 1], begin[i], 1e-15) << i;
        EXPECT_NEAR(end_slope[i + 1], slope[i], 1e-15) << i;
    }
    EXPECT_EQ(begin[3], 0.0);
    EXPECT_EQ(end[0], 0.0);
}

TEST(Ease, RisesFromZeroToOneAndIsLevelAtBothEnds) {
    EXPECT_EQ(ease_cubic(0.0), 0.0);
    EXPECT_EQ(ease_cubic(1.0), 1.0);
    EXPECT_EQ(ease_quintic(0.0f), 0.0f);
    EXPECT_EQ(ease_quintic(1.0f), 1.0f);
    EXPECT_EQ(ease_cubic(0.5), 0.5);
    EXPECT_EQ(ease_quintic(0.5), 0.5);
    // A level end leaves the square of the step, an end without curvature its cube.
    constexpr double kStep = 1e-3;
    EXPECT_NEAR(ease_cubic(kStep), 3.0 * kStep * kStep, 1e-8);
    EXPECT_NEAR(1.0 - ease_cubic(1.0 - kStep), 3.0 * kStep * kStep, 1e-8);
    EXPECT_NEAR(ease_quintic(kStep), 10.0 * kStep * kStep * kStep, 1e-10);
    EXPECT_NEAR(1.0 - ease_quintic(1.0 - kStep), 10.0 * kStep * kStep * kStep, 1e-10);
}

TEST(Ease, IsHeldBeyondItsRangeAndHasItsIntegral) {
    EXPECT_EQ(ease(2.0, 4.0, 1.0), 0.0);
    EXPECT_EQ(ease(2.0, 4.0, 5.0), 1.0);
    EXPECT_EQ(ease(2.0, 4.0, 3.0), 0.5);
    EXPECT_EQ(ease(4.0, 2.0, 1.0), 1.0);  // falls
    constexpr double kStep = 1e-4;
    for (const double t : {-0.5, 0.1, 0.5, 0.9, 1.5}) {
        const double slope = (ease_integral(t + kStep) - ease_integral(t - kStep)) / (2.0 * kStep);
        EXPECT_NEAR(slope, ease(0.0, 1.0, t), 1e-7) << t;
    }
}

TEST(Bilinear, HasTheCornersAndIsStraightAlongEachSide) {
    const auto at = [](double u, double v) { return bilinear(1.0, 3.0, 7.0, 4.0, u, v); };
    EXPECT_EQ(at(0.0, 0.0), 1.0);
    EXPECT_EQ(at(1.0, 0.0), 3.0);
    EXPECT_EQ(at(0.0, 1.0), 7.0);
    EXPECT_EQ(at(1.0, 1.0), 4.0);
    EXPECT_EQ(at(0.5, 0.0), 2.0);
    EXPECT_EQ(at(1.0, 0.5), 3.5);
    EXPECT_EQ(at(0.5, 0.5), 3.75);
}

}  // namespace
}  // namespace ocean
