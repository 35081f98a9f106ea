// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// One dispersion relation whose limits are the textbook's.
#include "ocean/internal/dispersion.hpp"

#include "ocean/internal/grid.hpp"
#include "testing.hpp"

namespace ocean {
namespace {

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
