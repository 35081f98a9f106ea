// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Inverting the displacement of waves that are known, and of sources that cannot be inverted.
#include "waves/query/inversion.hpp"

#include "ocean/internal/grid.hpp"
#include "testing.hpp"

namespace ocean {
namespace {

TEST(Inversion, EndsWithAFiniteLabelWhateverTheSourceIs) {
    int looks = 0;
    const auto wild = [&](double x, double y) {  // shows every label at the same place
        ++looks;
        return DisplacementSample{x + 5.0, y, 1e11 * std::cos(1e5 * x), -1e11 * std::sin(1e5 * y),
                                  1e9};
    };
    const ShownLabel label = find_label(wild, InversionTarget::at(0.3, 0.4, 1.0, 2.0), 0.3, 0.4);
    EXPECT_EQ(looks, 40);
    EXPECT_FALSE(label.converged);
    EXPECT_TRUE(std::isfinite(label.x + label.y + label.jacobian));
    const auto flat = [](double, double) { return DisplacementSample{0.0, 0.0, 1.0, 1.0, 0.0}; };
    EXPECT_TRUE(std::isfinite(
        find_label(flat, InversionTarget::at(0.3, 0.4, 1.0, 2.0), 5.0, 0.4).jacobian));
}

TEST(Inversion, OfAGentleWaveTakesFiveLooks) {
    int looks = 0;
    const auto wave = [&](double x, double) {
        ++looks;
        return DisplacementSample{std::sin(x), 0.0, std::cos(x), 0.0, 0.0};
    };
    for (int i = 0; i < 100; ++i) {
        looks = 0;
        EXPECT_TRUE(
            find_label(wave, InversionTarget::at(0.1 * i, 2.0, 0.5, 0.5), 0.1 * i, 2.0).converged);
        EXPECT_LE(looks, 5);
    }
}

}  // namespace
}  // namespace ocean
