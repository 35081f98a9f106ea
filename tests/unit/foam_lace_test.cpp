// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The formulas of shaders/wave/foam_lace.glsl: combined textures are uniform again, masks have the
// mean that the cover says, thickness the one that is said of it.

#include "wave/wave.hpp"

#include "foam_variance.hpp"
#include "testing.hpp"

namespace ocean {
namespace {

namespace formula = wave::double_precision;

constexpr double kCovers[] = {0.003, 0.02, 0.049, 0.1, 0.27, 0.5, 0.7, 0.9, 0.96, 0.997};

/// The mean of f over uniform values.
template <typename F>
double mean(F f, int steps = 200000) {
    double sum = 0.0;
    for (int i = 0; i < steps; ++i) sum += f((i + 0.5) / steps);
    return sum / steps;
}
/// Over two that are independent: points of the golden section, whose shares are right to 2e-5.
template <typename F>
double mean_of_two(F f) {
    constexpr int kPoints = 1'000'000;
    double sum = 0.0;
    for (int i = 0; i < kPoints; ++i) {
        const double turns = 0.6180339887498949 * i;
        sum += f((i + 0.5) / kPoints, turns - std::floor(turns));
    }
    return sum / kPoints;
}

TEST(FoamLace, SumsAndUnionsOfUniformTexturesAreUniform) {
    for (const double cover : kCovers) {
        for (const double share : {0.05, 0.25, 1.0}) {
            const auto sum = [&](double a, double b) {
                return formula::add_uniform(a, b, share) < cover ? 1.0 : 0.0;
            };
            EXPECT_NEAR(mean_of_two(sum), cover, 1e-4) << "share " << share;
        }
        for (const double begins : {0.0, 0.08, 0.4, 1.0}) {
            const auto both = [&](double a, double b) {
                return formula::unite_uniform(a, b, begins) < cover ? 1.0 : 0.0;
            };
            EXPECT_NEAR(mean_of_two(both), cover, 1e-4) << "begins " << begins;
        }
    }
}

TEST(FoamLace, CombinedTexturesReachFromZeroToOneWithoutAStep) {
    for (const double share : {0.05, 0.25, 1.0}) {
        EXPECT_EQ(formula::add_uniform(0.0, 0.0, share), 0.0);
        EXPECT_DOUBLE_EQ(formula::add_uniform(1.0, 1.0, share), 1.0);
        for (const double z : {share, 1.0}) {
            EXPECT_NEAR(formula::add_uniform(z - 1e-9, 0.0, share),
                        formula::add_uniform(z, 1e-9, share), 1e-8);
        }
    }
    EXPECT_EQ(formula::unite_uniform(0.0, 1.0, 0.08), 0.0);
    EXPECT_DOUBLE_EQ(formula::unite_uniform(1.0, 1.0, 0.08), 1.0);
    // Below where the other begins, the first alone.
    EXPECT_DOUBLE_EQ(formula::unite_uniform(0.05, 0.0, 0.08), 0.05);
}

TEST(FoamLace, MeanOfTheMaskIsTheCover) {
    for (const double edge : {0.02, 0.1, 0.4, 1.0}) {
        for (const double cover : kCovers) {
            EXPECT_NEAR(mean([&](double t) { return formula::foam_mask(cover, t, edge); }), cover,
                        1e-8)
                << "edge " << edge;
            EXPECT_NEAR(mean([&](double t) {
                            const auto white = wave::single_precision::foam_mask(
                                static_cast<float>(cover), static_cast<float>(t),
                                static_cast<float>(edge));
                            return static_cast<double>(white);
                        }),
                        cover, 1e-6);
        }
        // All is water or all is foam, also where a host's interpolation overshoots.
        for (const double t : {0.0, 0.5, 1.0}) {
            for (const double none : {0.0, -0.1}) {
                EXPECT_NEAR(formula::foam_mask(none, t, edge), 0.0, 1e-12);
            }
            for (const double all : {1.0, 1.1}) {
                EXPECT_NEAR(formula::foam_mask(all, t, edge), 1.0, 1e-12);
            }
        }
    }
}

TEST(FoamLace, MeanThicknessIsThatOfTheFoamAlone) {
    for (const double span : {0.1, 0.35, 1.0}) {
        for (const double cover : kCovers) {
            const double all =
                mean([&](double t) { return formula::foam_thickness(cover, t, span); });
            EXPECT_NEAR(all / cover, formula::foam_mean_thickness(cover, span), 1e-6);
        }
        EXPECT_EQ(formula::foam_thickness(0.3, 0.3, span), 0.0);
        EXPECT_EQ(formula::foam_thickness(1.0, 0.0, span), 1.0);
        EXPECT_EQ(formula::foam_mean_thickness(0.0, span), 0.0);
    }
}

constexpr double kCell = 0.86;

TEST(FoamLace, FarFoamIsItsCover) {
    const auto faded = [](double footprint) {
        return formula::foam_faded(1.0, 0.3, footprint, kCell);
    };
    EXPECT_EQ(faded(0.1 * kCell), 1.0);
    EXPECT_DOUBLE_EQ(faded(0.8 * kCell), 0.65);
    EXPECT_DOUBLE_EQ(faded(1.5 * kCell), 0.3);
}

TEST(FoamLace, PixelsOfEverySizeShowTheCoverAndVaryByTheRule) {
    for (const double edge : {0.02, 0.1, 0.4}) {
        for (const double cover : kCovers) {
            double last = 1.0;
            for (const double footprint : {0.0, 0.1, 0.3, 0.6, 1.0, 2.0}) {
                const double soft = formula::foam_pixel_edge(edge, footprint, kCell);
                const auto shown = [&](double t) {
                    const double mask = formula::foam_mask(cover, t, soft);
                    return formula::foam_faded(mask, cover, footprint, kCell);
                };
                constexpr int kSteps = 10000;
                EXPECT_NEAR(mean(shown, kSteps), cover, 1e-7);
                const double squares = mean([&](double t) { return shown(t) * shown(t); }, kSteps);
                const double variance = test::foam_variance(cover, edge, footprint, kCell);
                EXPECT_NEAR(squares - cover * cover, variance, 1e-6) << cover << " " << footprint;
                EXPECT_LE(variance, last) << "pixels of " << footprint << " m";
                last = variance;
            }
            EXPECT_EQ(last, 0.0);
        }
    }
}

TEST(FoamLace, BlurredFoamIsAsBrightAsItsThicknessSays) {
    const double thick = formula::foam_mean_thickness(0.3, 0.35);
    EXPECT_EQ(formula::foam_pixel_thickness(0.1, thick, 0.0, kCell), 0.1);
    EXPECT_EQ(formula::foam_pixel_thickness(0.1, thick, 0.4 * kCell, kCell), thick);
}

TEST(FoamLace, StreaksGatherFoamAndAddNone) {
    for (const double cover : kCovers) {
        for (const double share : {0.0, 0.3, 1.0}) {
            const auto gathered = [&](double t) {
                return formula::foam_in_streaks(cover, t, share);
            };
            EXPECT_NEAR(mean(gathered), cover, 1e-8);
            EXPECT_EQ(gathered(0.0) > gathered(1.0), share > 0.0);
        }
    }
}

TEST(FoamLace, BubblesAreBelowAndAroundTheFoam) {
    const double cover = 0.1, just_outside = 0.2;
    EXPECT_EQ(formula::foam_mask(cover, just_outside, 0.1), 0.0);
    EXPECT_GT(formula::foam_bubbles(0.0, cover, just_outside), 0.1);
    EXPECT_EQ(formula::foam_bubbles(0.0, cover, 0.9), 0.0);
    EXPECT_EQ(formula::foam_bubbles(0.7, cover, 0.9), 0.7);
}

}  // namespace
}  // namespace ocean
