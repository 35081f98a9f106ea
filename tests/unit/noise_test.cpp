// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The noise is Gaussian, independent, and a pure function of (seed, cascade, n, m).

#include "base/noise_row.hpp"
#include "testing.hpp"
#include "wave/wave.hpp"

namespace ocean {
namespace {

namespace in_double = wave::double_precision;
namespace in_float = wave::single_precision;

std::vector<double> draws(std::uint32_t seed, std::uint32_t cascade) {
    std::vector<double> values;
    for (const auto [n, m] : test::pairs({-100, 100}, {-100, 100})) {
        const in_double::Gaussian xi = in_double::gaussian_noise(seed, cascade, n, m);
        values.push_back(xi.re);
        values.push_back(xi.im);
    }
    return values;
}

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum / static_cast<double>(a.size());
}

TEST(Noise, PhiloxGivesThePublishedKnownAnswers) {
    const auto words = [](const in_double::RandomBits& r) {
        return std::vector<std::uint32_t>{r.a, r.b, r.c, r.d};
    };
    // kat_vectors of [Salmon 2011]'s Random123: zeros, ones, digits of pi.
    EXPECT_EQ(words(in_double::philox_4x32(0, 0, 0, 0, 0, 0)),
              (std::vector<std::uint32_t>{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
    EXPECT_EQ(words(in_double::philox_4x32(~0u, ~0u, ~0u, ~0u, ~0u, ~0u)),
              (std::vector<std::uint32_t>{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
    EXPECT_EQ(words(in_double::philox_4x32(0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344,
                                           0xa4093822, 0x299f31d0)),
              (std::vector<std::uint32_t>{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

TEST(Noise, IsStandardNormalByTheKolmogorovSmirnovTest) {
    std::vector<double> values = draws(1, 0);
    std::sort(values.begin(), values.end());
    const auto n = static_cast<double>(values.size());
    double distance = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double cdf = 0.5 * std::erfc(-values[i] / std::sqrt(2.0));
        distance = std::max({distance, std::abs(cdf - static_cast<double>(i) / n),
                             std::abs(cdf - static_cast<double>(i + 1) / n)});
    }
    EXPECT_LT(distance, 1.63 / std::sqrt(n)) << "1 % level";
}

TEST(Noise, SeedsCascadesAndMirroredModesAreIndependent) {
    const std::vector<double> one = draws(1, 0);
    const double bound = 4.0 / std::sqrt(static_cast<double>(one.size()));
    EXPECT_LT(std::abs(correlation(one, draws(2, 0))), bound);
    EXPECT_LT(std::abs(correlation(one, draws(1, 1))), bound);
    double mirrored = 0.0;
    for (const auto [n, m] : test::pairs({-150, 150}, {1, 150})) {
        mirrored +=
            in_double::gaussian_noise(1, 0, n, m).re * in_double::gaussian_noise(1, 0, -n, -m).re;
    }
    EXPECT_LT(std::abs(mirrored / 44700.0), 4.0 / std::sqrt(44700.0));
}

TEST(Noise, MinusLogUniformIsExactAtBothEndsAndNeverInfinite) {
    for (const std::uint32_t x :
         {0u, 1u, 2u, 1000u, 0x7fffffffu, 3037000499u, 3037000500u, 0xfffffff0u, 0xffffffffu}) {
        const double u = (x + 0.5) / 4294967296.0;
        const double exact =
            u > 0.5 ? -std::log1p(-(4294967295.0 - x + 0.5) / 4294967296.0) : -std::log(u);
        EXPECT_NEAR(in_double::minus_log_uniform(x) / exact, 1.0, 4e-16) << x;
        EXPECT_NEAR(in_float::minus_log_uniform(x) / exact, 1.0, 3e-7) << x;
    }
    for (std::uint32_t x = 0; x < 0xffff0000u; x += 65521u) {
        ASSERT_TRUE(std::isfinite(in_double::minus_log_uniform(x)));
    }
}

TEST(Noise, FloatAgreesWithDouble) {
    for (int n = -500; n < 500; ++n) {
        const auto a = in_double::gaussian_noise(9, 2, n, 3 * n + 1);
        const auto b = in_float::gaussian_noise(9, 2, n, 3 * n + 1);
        EXPECT_NEAR(a.re, b.re, 2e-6);
        EXPECT_NEAR(a.im, b.im, 2e-6);
    }
}

TEST(Noise, ARowHasTheBitsOfTheFormula) {
    std::vector<std::complex<float>> row(1000);
    for (const std::uint32_t seed : {0u, 1u, 4294967295u}) {
        for (int m = -40; m < 41; ++m) {
            const auto cascade = static_cast<std::uint32_t>(m & 3);
            noise_row(seed, cascade, -500, m, row);
            for (int i = 0; i < 1000; ++i) {
                const auto xi = in_double::gaussian_noise(seed, cascade, i - 500, m);
                const std::complex<float> exact(static_cast<float>(xi.re),
                                                static_cast<float>(xi.im));
                const std::complex<float>& found = row[static_cast<std::size_t>(i)];
                ASSERT_EQ(std::memcmp(&found, &exact, sizeof(exact)), 0) << i << " " << m;
            }
        }
    }
    std::complex<float> guarded[3] = {7.0f, 7.0f, 7.0f};
    noise_row(1, 0, 3, 4, std::span(guarded).subspan(1, 1));
    EXPECT_EQ(guarded[0], 7.0f);
    EXPECT_EQ(guarded[2], 7.0f) << "a row ends where it is asked to";
}

TEST(Turns, SineAndCosineAreThoseOfTheCLibrary) {
    for (int i = -4000; i <= 4000; ++i) {
        const double turns = i / 997.0;
        const auto d = in_double::sin_cos_turns(turns);
        EXPECT_NEAR(d.sine, std::sin(turns * 2.0 * M_PI), 5e-15);
        EXPECT_NEAR(d.cosine, std::cos(turns * 2.0 * M_PI), 5e-15);
        const auto f = in_float::sin_cos_turns(static_cast<float>(turns));
        const double held = static_cast<float>(turns);
        EXPECT_NEAR(f.sine, std::sin(held * 2.0 * M_PI), 2e-7);
        EXPECT_NEAR(f.cosine, std::cos(held * 2.0 * M_PI), 2e-7);
    }
}

TEST(Phase, IsAsExactAfterElevenDaysAsAfterASecond) {
    for (const double time : {1.0, 12.0, 1e6}) {
        for (int i = 1; i < 2000; ++i) {
            const double rate = 0.0031 * i;
            const auto high = static_cast<float>(rate);
            const auto low = static_cast<float>(rate - high);
            const auto time_high = static_cast<float>(time);
            const auto time_low = static_cast<float>(time - time_high);
            const double exact = std::remainder((static_cast<double>(high) + low) * time, 1.0);
            const double got = in_float::phase_turns(high, low, time_high, time_low);
            EXPECT_NEAR(std::remainder(got - exact, 1.0), 0.0, 2e-7) << rate << " " << time;
        }
    }
}

}  // namespace
}  // namespace ocean
