// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Breaking waves: limits of the formulas, and what limiter and shape keep of a random sea.
#include "coast/statics/breaking.hpp"

#include "ocean/internal/dispersion.hpp"
#include "ocean/internal/grid.hpp"
#include "wave_moments.hpp"

namespace ocean {
namespace {

constexpr double kPeakOmega = 0.85;  // of waves of 7.4 s

double wavenumber(double depth) {
    return Dispersion(Water{.depth = depth}).wavenumber(kPeakOmega);
}

/// A value with its derivative with respect to one variable.
struct Dual {
    double value = 0.0;
    double slope = 0.0;

    Dual() = default;
    explicit Dual(double v, double s = 0.0) : value(v), slope(s) {}
    Dual operator-() const { return Dual(-value, -slope); }
};
Dual operator+(const Dual& a, const Dual& b) {
    return Dual(a.value + b.value, a.slope + b.slope);
}
Dual operator-(const Dual& a, const Dual& b) {
    return Dual(a.value - b.value, a.slope - b.slope);
}
Dual operator*(const Dual& a, const Dual& b) {
    return Dual(a.value * b.value, a.slope * b.value + a.value * b.slope);
}
Dual operator/(const Dual& a, const Dual& b) {
    return Dual(a.value / b.value, (a.slope - a.value / b.value * b.slope) / b.value);
}
double value_of(const Dual& x) {
    return x.value;
}
Dual sqrt(const Dual& x) {
    return Dual(std::sqrt(x.value), 0.5 * x.slope / std::sqrt(x.value));
}
Dual log(const Dual& x) {
    return Dual(std::log(x.value), x.slope / x.value);
}
Dual tanh(const Dual& x) {
    const double t = std::tanh(x.value);
    return Dual(t, (1.0 - t * t) * x.slope);
}
Dual pow(const Dual& x, const Dual& p) {
    return Dual(std::pow(x.value, p.value), p.value * std::pow(x.value, p.value - 1.0) * x.slope);
}
Dual sin(const Dual& x) {
    return Dual(std::sin(x.value), std::cos(x.value) * x.slope);
}
Dual cos(const Dual& x) {
    return Dual(std::cos(x.value), -std::sin(x.value) * x.slope);
}

TEST(Breaking, HighestWaveIsMichesInDeepWaterAndAShareOfTheDepthInShallow) {
    const double index = breaker_index(0.0);
    EXPECT_EQ(index, 0.75);
    EXPECT_NEAR(highest_wave(0.1, 1e4, index), 0.14 * kTwoPi / 0.1, 0.01);  // 0.88 / 2 pi = 0.14
    EXPECT_NEAR(highest_wave(1e-3, 2.0, index), 0.75 * 2.0, 1e-5);
    // Hand value: 15 * 0.1^(4/3) = 0.69624; beyond 0.4 the slope has no further effect.
    EXPECT_NEAR(breaker_index(0.05), 0.75 * (1.0 + 15.0 * std::pow(0.05, 4.0 / 3.0)), 1e-14);
    EXPECT_NEAR(breaker_index(0.05), 0.75 * 1.27630, 1e-5);
    EXPECT_EQ(breaker_index(0.1), 0.75 * 1.4);
}

TEST(Breaking, LimiterIsSmoothAtItsKneeAndBelowOne) {
    for (const double u : {0.0, 0.3, 0.7}) EXPECT_EQ(limited(u), u);
    const double step = 1e-4;
    EXPECT_NEAR((limited(0.7 + step) - limited(0.7)) / step, 1.0, 1e-6);
    double previous = 0.7;
    for (double u = 0.8; u < 4.0; u += 0.1) {
        EXPECT_GT(limited(u), previous);
        previous = limited(u);
    }
    EXPECT_LE(limited(1e6), 1.0);
}

TEST(Breaking, DissipationIsThorntonAndGuzas) {
    // Hand value, H = 0.42 d = 0.84 m, f = 0.125 Hz: (3 sqrt(pi) / 16) f H^3 / d (1 - 2^(-5/2)).
    EXPECT_NEAR(breaking_dissipation(0.84, 2.0, 0.125), 0.0101347, 1e-7);
    // Low waves: H^7, by the first term of the binomial series.
    EXPECT_NEAR(breaking_dissipation(0.02, 2.0, 0.1) / breaking_dissipation(0.01, 2.0, 0.1), 128.0,
                0.2);
}

TEST(Breaking, ShareThatBreaksIsTheIntegralOfItsWeight) {
    // Weight v (1 - exp(-(H / (gamma d))^2)) over Rayleigh's density, by the midpoint rule.
    for (const double rms : {0.2, 0.6, 0.9}) {
        const double d = 2.0, v = std::pow(rms / (kSurfGamma * d), 2.0);
        double sum = 0.0;
        const double step = 1e-3;
        for (double h = 0.5 * step; h < 8.0; h += step) {
            sum += v * (1.0 - std::exp(-std::pow(h / (kSurfGamma * d), 2.0))) * 2.0 * h /
                   (rms * rms) * std::exp(-h * h / (rms * rms)) * step;
        }
        EXPECT_NEAR(share_that_breaks(rms, d), sum, 1e-5);
    }
    EXPECT_EQ(share_that_breaks(3.0, 1.0), 1.0);
}

TEST(Breaking, NonlinearityIsTheLogisticInTheLogarithmOfUrsell) {
    for (const double ursell : {1e-3, 0.1, 0.339, 1.0, 20.0}) {
        const double logistic = 0.857 / (1.0 + std::exp((-0.471 - std::log10(ursell)) / 0.297));
        EXPECT_NEAR(nonlinearity(ursell), logistic, 1e-12);
        const double psi = 0.5 * kPi * (std::tanh(0.815 / std::pow(ursell, 0.672)) - 1.0);
        EXPECT_NEAR(biphase(ursell), psi, 1e-12);
    }
    EXPECT_EQ(nonlinearity(0.0), 0.0);
    EXPECT_EQ(biphase(0.0), 0.0);
    EXPECT_NEAR(biphase(1e4), -0.5 * kPi, 0.01);
}

TEST(Breaking, CrestsKeepTheirHeightTheirMeanAndTheirSkewness) {
    // Over a period: 2 |Z| from crest to trough, mean 0, skewness and asymmetry B cos and B sin
    // psi.
    for (const double b : {0.1, 0.4, 0.68}) {
        for (const double psi : {0.0, -0.5, -1.2}) {
            const double r = shape_of_nonlinearity(b), phi = -psi - 0.5 * kPi;
            const int n = 4096;
            std::vector<std::complex<double>> h(n);
            double highest = -9.0, lowest = 9.0, mean = 0.0;
            for (int i = 0; i < n; ++i) {
                const double phase = -kTwoPi * i / n;  // falls in time
                const double height =
                    crest_shape(2.0 * std::cos(phase), 2.0 * std::sin(phase), r, phi);
                h[static_cast<std::size_t>(i)] = height;
                highest = std::max(highest, height);
                lowest = std::min(lowest, height);
                mean += height / n;
            }
            EXPECT_NEAR(highest - lowest, 4.0, 1e-4);
            EXPECT_NEAR(mean, 0.0, 1e-12);
            double square = 0.0, cube = 0.0;
            for (const auto& x : h) {
                square += x.real() * x.real() / n;
                cube += std::pow(x.real(), 3.0) / n;
            }
            const double skewness = cube / std::pow(square, 1.5);
            EXPECT_NEAR(skewness, b * std::cos(psi), 1e-6) << b << " " << psi;
        }
    }
}

TEST(Breaking, StillWaterStaysStillAndFloatsAgree) {
    EXPECT_NEAR(crest_shape(0.0, 0.0, 0.5, -1.0), 0.0, 1e-6);
    EXPECT_EQ(crest_shape(1.5, -0.7, 0.0, -0.5 * kPi), 1.5);
    const float f = crest_shape(0.8f, 0.4f, 0.4f, -1.0f);
    EXPECT_NEAR(double{f}, crest_shape(0.8, 0.4, 0.4, -1.0), 1e-6);
    EXPECT_NEAR(double{broken_wave(0.8f, 0.4f, 1.5f, 1.1f, 0.2f, 2.0f).height},
                broken_wave(0.8, 0.4, 1.5, 1.1, 0.2, 2.0).height, 1e-5);
}

TEST(Breaking, DualNumbersReturnTheDerivatives) {
    // Along a path in all inputs at once, against a two-sided step, below and above the knee.
    const LimiterGain gain;
    const auto along = [&gain](const auto& t) {
        using Real = std::decay_t<decltype(t)>;
        const Real d = Real(2.0) + t, k = Real(0.19) - Real(0.03) * t;
        const Real rms = Real(0.8) + Real(0.3) * t;
        const Real highest = highest_wave(k, d, breaker_index(Real(0.03) + Real(0.01) * t));
        const Real c = gain(rms / highest, typical_shape_root(rms, k, d));
        const Real re = Real(0.3) + Real(0.4) * t, im = Real(0.2) - Real(0.6) * t;
        const Real source = breaking_source(re, im, rms, d, share_that_breaks(rms, d));
        return broken_wave(re, im, highest, c, k, d).height + breaking_dissipation(rms, d, k) +
               source;
    };
    for (const double t : {-0.6, 0.013, 0.4, 1.37}) {
        const double step = 1e-5;
        const double slope = (along(t + step) - along(t - step)) / (2.0 * step);
        EXPECT_NEAR(along(Dual(t, 1.0)).slope, slope, 1e-6) << t;
    }
    EXPECT_TRUE(std::isfinite(
        broken_wave(Dual(0.0, 1.0), Dual(0.0, 1.0), Dual(1.5), Dual(1.1), Dual(0.2), Dual(2.0))
            .height.slope));
}

TEST(Breaking, FoamBeginsOnFrontFacesOfTheHighestWaves) {
    const double d = 2.0, rms = 0.8, share = share_that_breaks(rms, d);
    const double high = rms * std::sqrt(-std::log(share));  // twice the threshold
    const auto at = [&](double amplitude, double phase) {
        return breaking_source(amplitude * std::cos(phase), amplitude * std::sin(phase), rms, d,
                               share);
    };
    EXPECT_EQ(at(high, 0.55), 1.0);
    EXPECT_EQ(at(high, -0.55), 0.0);
    EXPECT_EQ(at(high, 0.55 + kPi), 0.0);
    EXPECT_EQ(at(0.45 * high, 0.55), 0.0);
    EXPECT_EQ(breaking_source(high, 0.5 * high, rms, rms / 0.12, share), 0.0);
}

/// The real part of a narrow band of waves about kPeakOmega at one place, and its envelope.
std::vector<std::complex<double>> narrow_band(double rms_height, int samples, double step) {
    std::vector<std::complex<double>> z(static_cast<std::size_t>(samples));
    std::mt19937_64 random(5);
    std::normal_distribution<double> normal;
    const double unit = kTwoPi / (samples * step);  // frequencies of the record, which repeats
    const double width = 0.06;
    std::vector<std::complex<double>> spectrum(z.size());
    double variance = 0.0;
    for (std::size_t n = 1; n < z.size() / 2; ++n) {
        const double x = (static_cast<double>(n) * unit - kPeakOmega) / width;
        if (std::abs(x) > 4.0) continue;
        const double a = std::exp(-0.25 * x * x), re = normal(random), im = normal(random);
        spectrum[n] = {a * re, a * im};
        variance += 0.5 * std::norm(spectrum[n]);
    }
    const double scale = rms_height / std::sqrt(8.0 * variance);
    // exp(-i omega t): a phase that falls in time.
    Radix2Fft<double>(samples).transform(spectrum.data(), 1, FftDirection::forward);
    for (std::size_t i = 0; i < z.size(); ++i) z[i] = scale * spectrum[i];
    return z;
}

TEST(Breaking, RandomWavesHaveRuessinksSkewnessAndAsymmetry) {
    // Narrow bands come to 0.033; without kShapeShare they would differ by 0.1.
    const LimiterGain gain;
    for (const double d : {1.0, 1.5, 2.0, 3.0, 5.0, 8.0}) {
        const double rms = std::min(0.42 * d, 1.9), k = wavenumber(d);
        const double highest = highest_wave(k, d, breaker_index(1.0 / 30.0));
        const double c = gain(rms / highest, typical_shape_root(rms, k, d));
        std::vector<double> heights;
        for (const auto& z : narrow_band(rms, 1 << 15, 0.25)) {
            heights.push_back(broken_wave(z.real(), z.imag(), highest, c, k, d).height);
        }
        const double ursell = ursell_number(rms / std::sqrt(2.0), k, d);
        const double b = nonlinearity(ursell), psi = biphase(ursell);
        const Moments moments = moments_of({heights});
        EXPECT_NEAR(moments.skewness, b * std::cos(psi), 0.06) << d;
        EXPECT_NEAR(moments.asymmetry, b * std::sin(psi), 0.06) << d;
    }
}

TEST(Breaking, NoWaveIsHigherThanTheHighest) {
    // Amplitudes up to ten times the highest; a shaped wave measures 2 |Z| from crest to trough.
    const LimiterGain gain;
    for (const double d : {0.6, 2.0, 10.0, 100.0}) {
        const double k = wavenumber(d), highest = highest_wave(k, d, breaker_index(0.02));
        for (const double rms : {0.2, 0.5, 0.7, 1.5}) {
            const double c = gain(rms, typical_shape_root(rms * highest, k, d));
            for (double amplitude = 0.01; amplitude < 5.0; amplitude += 0.05) {
                double top = -99.0, bottom = 99.0;
                for (int i = 0; i < 64; ++i) {
                    const double x = kTwoPi * i / 64.0, a = amplitude * highest;
                    const double h =
                        broken_wave(a * std::cos(x), a * std::sin(x), highest, c, k, d).height;
                    top = std::max(top, h);
                    bottom = std::min(bottom, h);
                }
                EXPECT_LE(top - bottom, highest * (1.0 + 1e-12));
            }
        }
    }
}

TEST(Breaking, GainKeepsTheVariance) {
    // By quadrature over phase and Rayleigh's heights, for all waves that a shore can have.
    const LimiterGain gain;
    for (const double d : {0.8, 1.5, 4.0, 20.0}) {
        const double k = wavenumber(d), highest = highest_wave(k, d, breaker_index(1.0 / 30.0));
        for (const double ratio : {0.1, 0.3, 0.5, 0.6, 0.7}) {
            const double rms = ratio * highest;
            const double c = gain(ratio, typical_shape_root(rms, k, d));
            double variance = 0.0;
            const int levels = 400, phases = 32;
            for (int i = 0; i < levels; ++i) {
                const double a = 0.5 * rms * std::sqrt(-std::log((i + 0.5) / levels));
                for (int j = 0; j < phases; ++j) {
                    const double x = kTwoPi * j / phases;
                    const double h =
                        broken_wave(a * std::cos(x), a * std::sin(x), highest, c, k, d).height;
                    variance += h * h / (levels * phases);
                }
            }
            EXPECT_NEAR(8.0 * variance / (rms * rms), 1.0, 0.02) << d << " " << ratio;
        }
    }
    EXPECT_EQ(gain(0.0, 1.0), 1.0);
    EXPECT_NEAR(gain(0.1, 1.0), 1.0, 1e-6);
}

}  // namespace
}  // namespace ocean
