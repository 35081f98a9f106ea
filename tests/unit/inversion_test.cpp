// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Inverting the displacement of waves that are known, and of sources that cannot be inverted.
#include "query/inversion.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "ocean/grid.hpp"

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

TEST(Inversion, OfASourceAloneFindsTheTopOfAFoldToo) {
    // One wave, D = sin a along x, h = cos a, folded at every crest.
    const double c = 1.6;
    const auto source = [](double x, double) {
        return DisplacementSample{std::sin(x), 0.0, std::cos(x), 0.0, 0.0};
    };
    const auto height = [](double x, double) { return std::cos(x); };
    for (int i = 0; i <= 60; ++i) {
        const double x = -kPi + kTwoPi * i / 60.0;
        double top = -2.0;
        int labels = 0;
        const auto off = [&](double a) { return a - c * std::sin(a) - x; };
        for (double a = -6.0; a < 6.0; a += 1e-4) {
            if ((off(a) < 0.0) == (off(a + 1e-4) < 0.0)) continue;
            top = std::max(top, std::cos(a));
            ++labels;
        }
        const TopLabel found = find_top_label(source, height, InversionTarget::at(x, 0.0, c, c));
        EXPECT_TRUE(found.label.converged);
        EXPECT_NEAR(height(found.label.x, 0.0), top, 2e-3) << "at x = " << x;
        EXPECT_EQ(found.folded, labels > 1) << "at x = " << x;
    }
}

}  // namespace
}  // namespace ocean
