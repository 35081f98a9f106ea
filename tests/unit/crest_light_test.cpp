// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// shaders/wave/crest_light.glsl and haze.glsl: where they are nothing, where most, numbers by hand.

#include "wave/wave.hpp"

#include "testing.hpp"

namespace ocean {
namespace {

namespace formula = wave::double_precision;

TEST(CrestLight, IsNumbersByHand) {
    // (0.8 - 0.1) (1.4 - 0.6) 0.9^2 (0.15 + 0.3)^0.7
    EXPECT_NEAR(formula::crest_light(0.8, 0.6, 0.9, -0.3), 0.25937, 1e-5);
    // Very high, folded, straight against a sun on the horizon, on a vertical side.
    EXPECT_DOUBLE_EQ(formula::crest_light(3.0, -1.0, 1.0, -1.0), 1.0);
}

TEST(CrestLight, IsNoneInTroughsTowardsTheSunAndWithItBehindTheEye) {
    EXPECT_EQ(formula::crest_light(0.1, 0.5, 0.9, -0.3), 0.0);
    EXPECT_EQ(formula::crest_light(-1.0, 0.5, 0.9, -0.3), 0.0);
    EXPECT_EQ(formula::crest_light(0.8, 1.4, 0.9, -0.3), 0.0);   // stretched water
    EXPECT_EQ(formula::crest_light(0.8, 0.5, 0.0, -0.3), 0.0);   // no horizontal part
    EXPECT_EQ(formula::crest_light(0.8, 0.5, -0.9, -0.3), 0.0);  // the sun behind the eye
    EXPECT_EQ(formula::crest_light(0.8, 0.5, 0.9, 0.15), 0.0);   // a lit side
    EXPECT_GT(formula::crest_light(0.8, 0.5, 0.9, 0.14), 0.0);
}

TEST(CrestLight, GrowsWithHeightSqueezingAndTheSunAhead) {
    const double some = formula::crest_light(0.5, 0.8, 0.5, -0.2);
    EXPECT_GT(some, 0.0);
    EXPECT_GT(formula::crest_light(0.6, 0.8, 0.5, -0.2), some);
    EXPECT_GT(formula::crest_light(0.5, 0.7, 0.5, -0.2), some);
    EXPECT_DOUBLE_EQ(formula::crest_light(0.5, 0.8, 1.0, -0.2), 4.0 * some);
    EXPECT_GT(formula::crest_light(0.5, 0.8, 0.5, -0.3), some);
}

TEST(Haze, LeavesTwoPercentAtTheVisibility) {
    EXPECT_EQ(formula::haze(0.0, 2e4), 0.0);
    EXPECT_NEAR(formula::haze(2e4, 2e4), 0.98, 1e-5);
    // At twice the distance the remaining share is squared.
    EXPECT_NEAR(1.0 - formula::haze(2e4, 2e4), std::pow(1.0 - formula::haze(1e4, 2e4), 2), 1e-12);
}

}  // namespace
}  // namespace ocean
