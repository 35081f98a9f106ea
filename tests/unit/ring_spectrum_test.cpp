// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Claims: rings have the density of the law that made the heights, in m^4; a crop reads its
// exponent with the window, and about 1.5 whatever it is without; sides need not be powers of two,
// and a grid that is cut into squares reads as a whole one.
#include "ocean/internal/ring_spectrum.hpp"

#include "ocean/error.hpp"
#include "test_seas.hpp"

namespace ocean {
namespace {

/// Heights of N x N samples with the density S = level k^-2beta [m^4] at every wave.
struct PowerLaw {
    int n;
    double period;  // [m]
    double beta;
    double level;

    double density(double k) const { return level * std::pow(k, -2.0 * beta); }

    std::vector<float> heights(unsigned seed) const {
        std::mt19937_64 random(seed);
        std::normal_distribution<double> normal;
        const double dk = kTwoPi / period;
        std::vector<std::complex<double>> modes(static_cast<std::size_t>(n) *
                                                static_cast<std::size_t>(n));
        for (const auto [x, y, at] : test::cells(n, n)) {
            const int nx = x < n / 2 ? x : x - n, ny = y < n / 2 ? y : y - n;
            const double k = dk * std::hypot(nx, ny);
            const std::complex<double> xi(normal(random), normal(random));
            const bool skipped = (nx == 0 && ny == 0) || 2 * nx == -n || 2 * ny == -n;
            if (skipped) continue;
            // The real part of the transform has half of the energy of such a mode.
            modes[at] = xi * std::sqrt(density(k)) * dk;
        }
        Radix2Fft<double>(n).transform_2d(modes, FftDirection::inverse);
        std::vector<float> result;
        for (const std::complex<double>& mode : modes) {
            result.push_back(static_cast<float>(mode.real()));
        }
        return result;
    }
};

struct Crop {
    Domain domain;
    std::vector<float> heights;
};

Crop crop(const PowerLaw& law, const std::vector<float>& heights, int columns, int rows) {
    const double step = law.period / law.n;
    Crop result{{.origin = {500.0, 300.0},
                 .size = {step * (columns - 1), step * (rows - 1)},
                 .samples = {columns, rows},
                 .wraps = false},
                {}};
    for (const auto [i, j] : test::pairs(columns, rows)) {
        // A crop of a larger land has a tilt, too.
        result.heights.push_back(heights[static_cast<std::size_t>((j + 99) * law.n + i + 57)] +
                                 0.001f * static_cast<float>(i));
    }
    return result;
}

/// The mean of log10(density / law) over the rings within [lowest, highest].
double level_error(const std::vector<Ring>& rings, const PowerLaw& law, double lowest,
                   double highest) {
    double sum = 0.0, weight = 0.0;
    for (const Ring& ring : rings) {
        if (ring.wavenumber < lowest || ring.wavenumber > highest) continue;
        sum += ring.count * std::log10(ring.density / law.density(ring.wavenumber));
        weight += ring.count;
    }
    return sum / weight;
}

/// Returns beta of the law S ~ k^-2beta by least squares of log S over log k, weighted by count,
/// over the rings with k in [lowest, highest].
double amplitude_exponent(std::span<const Ring> rings, double lowest, double highest) {
    double weight = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
    for (const Ring& ring : rings) {
        if (ring.wavenumber < lowest || ring.wavenumber > highest || ring.density <= 0.0) continue;
        const double log_k = std::log(ring.wavenumber), log_s = std::log(ring.density);
        weight += ring.count;
        x += ring.count * log_k;
        y += ring.count * log_s;
        xx += ring.count * log_k * log_k;
        xy += ring.count * log_k * log_s;
    }
    return -0.5 * (weight * xy - x * y) / (weight * xx - x * x);
}

TEST(RingSpectrum, ATileReadsItsLawAndItsVariance) {
    for (const double beta : {1.2, 2.0, 2.8}) {
        const PowerLaw law{512, 1000.0, beta, 0.01};
        const std::vector<float> heights = law.heights(7);
        const Domain tile = Domain::tile(law.period, law.n);
        const std::vector<Ring> rings = measure_rings(tile, heights, test::pool());
        const double dk = kTwoPi / law.period;
        EXPECT_NEAR(amplitude_exponent(rings, 4.0 * dk, 1.0), beta, 0.01 * beta);
        EXPECT_NEAR(level_error(rings, law, 4.0 * dk, 1.0), 0.0, 0.02);
        // Without the longest waves: rings stand for all waves within them, so their sum is the
        // variance of the modes.
        double modes = 0.0, all = 0.0, mean = 0.0;
        for (const Ring& ring : rings) {
            modes += ring.count;
            all += 2.0 * ring.count * ring.density * dk * dk;
        }
        double variance = 0.0;
        for (const float h : heights) mean += double{h} / static_cast<double>(heights.size());
        for (const float h : heights) variance += (double{h} - mean) * (double{h} - mean);
        variance /= static_cast<double>(heights.size());
        EXPECT_NEAR(all / variance, 1.0, beta > 1.5 ? 1e-3 : 0.1) << beta;
        EXPECT_NEAR(modes, 0.5 * kPi * 256.0 * 256.0, 200.0);
        EXPECT_NEAR(rings.front().wavenumber, dk, 0.02 * dk);
        EXPECT_EQ(rings.front().count, 2.0);
    }
}

TEST(RingSpectrum, ACropNeedsItsWindow) {
    for (const double beta : {2.0, 2.4, 2.8}) {
        double with = 0.0, without = 0.0, level = 0.0;
        constexpr int kSeeds = 4;
        for (unsigned seed = 1; seed <= kSeeds; ++seed) {
            const PowerLaw law{512, 1000.0, beta, 0.01};
            const Crop land = crop(law, law.heights(seed), 300, 256);
            const auto exponent = [&](Taper taper) {
                const auto rings =
                    measure_rings(land.domain, land.heights, test::pool(), {.taper = taper});
                if (taper != Taper::none) level += level_error(rings, law, 0.1, 1.0) / kSeeds;
                return amplitude_exponent(rings, 0.0, 10.0);
            };
            with += exponent(Taper::automatic) / kSeeds;
            without += exponent(Taper::none) / kSeeds;
        }
        EXPECT_NEAR(with, beta, 0.02 * beta);
        EXPECT_GT(std::abs(without - beta), 0.15 * beta);
        EXPECT_NEAR(level, 0.0, 0.03);
    }
}

TEST(RingSpectrum, SidesNeedNotBePowersOfTwo) {
    const PowerLaw law{1024, 2000.0, 2.2, 0.01};
    const std::vector<float> heights = law.heights(11);
    for (const std::array<int, 2> sides : {std::array{513, 700}, std::array{900, 300}}) {
        const Crop land = crop(law, heights, sides[0], sides[1]);
        const auto rings = measure_rings(land.domain, land.heights, test::pool());
        EXPECT_NEAR(amplitude_exponent(rings, 0.0, 10.0), 2.2, 0.02 * 2.2);
        EXPECT_NEAR(level_error(rings, law, 0.05, 1.0), 0.0, 0.03);
        // The count is of independent waves, whatever the padding.
        double count = 0.0;
        for (const Ring& ring : rings) count += ring.count;
        EXPECT_NEAR(count / (0.5 * kPi * 0.16 * sides[0] * sides[1]), 1.0, 0.02);
    }
}

TEST(RingSpectrum, SquaresThatOverlapReadAsTheWhole) {
    const PowerLaw law{1024, 2000.0, 2.2, 0.01};
    const Crop land = crop(law, law.heights(3), 700, 500);
    const auto rings = measure_rings(land.domain, land.heights, test::pool(), {.max_side = 128});
    EXPECT_NEAR(amplitude_exponent(rings, 0.0, 10.0), 2.2, 0.02 * 2.2);
    EXPECT_NEAR(level_error(rings, law, 0.1, 1.0), 0.0, 0.03);
    EXPECT_NEAR(rings.front().wavenumber, 2.0 * kTwoPi / 250.0 * 1.1, 0.005);
}

TEST(RingSpectrum, ThreadsDoNotChangeABit) {
    const PowerLaw law{256, 500.0, 2.0, 0.01};
    const Crop land = crop(law, law.heights(5), 150, 120);
    ThreadPool one(1), three(3);
    const auto a = measure_rings(land.domain, land.heights, one);
    const auto b = measure_rings(land.domain, land.heights, three);
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(a[i].density, b[i].density);
}

TEST(RingSpectrum, WhatCannotBeMeasuredIsRefused) {
    std::vector<float> heights(32 * 32, 1.0f);
    const Domain domain{.size = {31.0, 31.0}, .samples = {32, 32}, .wraps = false};
    EXPECT_NO_THROW(measure_rings(domain, heights, test::pool()));
    heights[5] = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THROW(measure_rings(domain, heights, test::pool()), Error);
    heights[5] = 0.0f;
    Domain small = domain;
    small.samples = {8, 128};
    EXPECT_THROW(measure_rings(small, heights, test::pool()), Error);
    EXPECT_THROW(measure_rings(domain, std::span(heights).first(100), test::pool()), Error);
}

}  // namespace
}  // namespace ocean
