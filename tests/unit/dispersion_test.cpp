// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// One dispersion relation whose limits are the textbook's.
#include "ocean/internal/dispersion.hpp"

#include "ocean/internal/grid.hpp"
#include "testing.hpp"

namespace ocean {
namespace {

TEST(Dispersion, DeepLimitIsRootGk) {
    const Dispersion deep(Water{.surface_tension = 0.0});
    for (const double k : {1e-4, 0.01, 1.0, 100.0}) {
        EXPECT_NEAR(deep.angular_frequency(k) / std::sqrt(9.81 * k), 1.0, 1e-14);
        EXPECT_NEAR(deep.group_velocity(k) / (0.5 * std::sqrt(9.81 / k)), 1.0, 1e-13);
    }
}

TEST(Dispersion, ShallowLimitTravelsAtRootGd) {
    const Dispersion shallow(Water{.depth = 2.0});
    EXPECT_NEAR(shallow.angular_frequency(1e-4) / (1e-4 * std::sqrt(9.81 * 2.0)), 1.0, 1e-7);
    EXPECT_NEAR(shallow.group_velocity(1e-4) / std::sqrt(9.81 * 2.0), 1.0, 1e-7);
}

TEST(Dispersion, DepthSlowsWavesBetweenTheLimits) {
    // Hand value: d = 5 m, k = 0.2: sqrt(9.81 * 0.2 * tanh(1)) = 1.22239
    const Dispersion water(Water{.depth = 5.0, .surface_tension = 0.0});
    EXPECT_NEAR(water.angular_frequency(0.2), 1.22239, 1e-5);
}

TEST(Dispersion, CapillaryWavesGoWithKToTheThreeHalves) {
    const Water water;
    const double k = 1e5;
    EXPECT_NEAR(
        Dispersion(water).angular_frequency(k) / std::sqrt(water.kinematic_tension() * k * k * k),
        1.0, 1e-5);
}

TEST(Dispersion, GroupVelocityIsTheDerivativeOfOmega) {
    for (const double depth : {0.5, 5.0, 50.0, 1e9}) {
        const Dispersion water(Water{.depth = depth});
        for (double k = 1e-3; k < 1e4; k *= 1.7) {
            const double step = 1e-5 * k;
            const double slope =
                (water.angular_frequency(k + step) - water.angular_frequency(k - step)) /
                (2.0 * step);
            EXPECT_NEAR(water.group_velocity(k) / slope, 1.0, 1e-6) << k << " " << depth;
        }
    }
}

TEST(Dispersion, InverseFindsTheWavenumberAgain) {
    for (const double depth : {0.01, 1.0, 30.0, std::numeric_limits<double>::infinity()}) {
        const Dispersion water(Water{.depth = depth});
        for (double k = 1e-5; k < 1e5; k *= 2.3) {
            EXPECT_NEAR(water.wavenumber(water.angular_frequency(k)) / k, 1.0, 1e-12)
                << k << " " << depth;
        }
    }
}

TEST(Dispersion, DisplacementIsOneInDeepWaterAndCothInShallow) {
    EXPECT_EQ(Dispersion(Water{}).horizontal_displacement(0.1), 1.0);
    EXPECT_NEAR(Dispersion(Water{.depth = 5.0}).horizontal_displacement(0.2), 1.0 / std::tanh(1.0),
                1e-14);
}

}  // namespace
}  // namespace ocean
