// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Directional distributions: normalised over the full circle, in the right direction, never
// negative; and the estimate of measured ones.
#include "ocean/internal/spreading.hpp"

#include "ocean/internal/grid.hpp"
#include "testing.hpp"

namespace ocean {
namespace {

constexpr SpreadingKind kSpreadings[] = {SpreadingKind::cosine_squared, SpreadingKind::mitsuyasu,
                                         SpreadingKind::hasselmann, SpreadingKind::donelan_banner};

double integral(const std::vector<double>& row) {
    double sum = 0.0;
    for (const double value : row) sum += value;
    return sum * kTwoPi / static_cast<double>(row.size());
}

std::complex<double> moment(const std::vector<double>& row, int order) {
    std::complex<double> sum = 0.0;
    for (std::size_t j = 0; j < row.size(); ++j) {
        sum += row[j] * std::polar(1.0, order * kTwoPi * static_cast<double>(j) /
                                            static_cast<double>(row.size()));
    }
    return sum * kTwoPi / static_cast<double>(row.size());
}

WaveSystem with(SpreadingKind kind) {
    WaveSystem system;
    system.spectrum = SpectrumKind::jonswap;
    system.spreading = kind;
    return system;
}

/// Returns the distribution of that system at x times its peak.
std::vector<double> row_of(const WaveSystem& system, double x = 1.0, double age = 1.0,
                           double direction = 0.0, std::size_t directions = 1024) {
    std::vector<double> row(directions);
    spreading_row(system, x, age, direction, row);
    return row;
}

/// Returns the distribution that is estimated from two moments.
std::vector<double> estimated(std::complex<double> c1, std::complex<double> c2,
                              Estimator estimator = Estimator::maximum_entropy,
                              std::size_t directions = 1024) {
    std::vector<double> row(directions);
    estimate_row(c1.real(), c1.imag(), c2.real(), c2.imag(), estimator, row);
    return row;
}

/// Returns the factor that normalises |cos(theta/2)|^(2s) over the full circle.
double cosine_2s_normalisation(double s) {
    // ln Q = (2s-1) ln 2 - ln pi + 2 ln Gamma(s+1) - ln Gamma(2s+1): tgamma overflows from s = 86.
    return std::exp((2.0 * s - 1.0) * std::log(2.0) - std::log(kPi) + 2.0 * std::lgamma(s + 1.0) -
                    std::lgamma(2.0 * s + 1.0));
}

TEST(Spreading, EveryKindIntegratesToOneOverTheFullCircle) {
    for (const SpreadingKind kind : kSpreadings) {
        for (const double swell : {-1.0, -0.4, 0.0, 0.5, 1.0}) {
            for (const double x : {0.3, 0.94, 1.0, 1.3, 2.0, 8.0}) {
                WaveSystem system = with(kind);
                system.swell = swell;
                const auto row = row_of(system, x, 0.9, 0.7);
                EXPECT_NEAR(integral(row), 1.0, 1e-12);
                for (const double value : row) ASSERT_GE(value, 0.0);
            }
        }
    }
}

TEST(Spreading, RowsAreTheClosedForms) {
    const double theta = kTwoPi * 100 / 1024.0;
    const auto cosine = row_of(with(SpreadingKind::cosine_squared));
    EXPECT_NEAR(cosine[100], 2.0 / kPi * std::pow(std::cos(theta), 2.0), 1e-9);
    EXPECT_EQ(cosine[512], 0.0) << "nothing travels against the wind";
    const double s = 9.77 * std::pow(1.5, -2.33 - 1.45 * (1.1 - 1.17));
    EXPECT_NEAR(hasselmann_exponent(1.5, 1.1), s, 1e-12);
    EXPECT_NEAR(row_of(with(SpreadingKind::hasselmann), 1.5, 1.1)[100],
                cosine_2s_normalisation(s) * std::pow(std::cos(0.5 * theta), 2.0 * s), 1e-9);
    const double beta = 2.28 * std::pow(1.2, -1.3);
    EXPECT_NEAR(row_of(with(SpreadingKind::donelan_banner), 1.2)[100],
                beta / (2.0 * std::tanh(beta * kPi) * std::pow(std::cosh(beta * theta), 2.0)),
                1e-5);
}

TEST(Spreading, SwellAlignsLongWavesMore) {
    EXPECT_NEAR(swell_exponent(2.0, 1.0), 7.394, 5e-4);
    EXPECT_NEAR(swell_exponent(4.0, 1.0), 3.92, 5e-3);
    WaveSystem system = with(SpreadingKind::donelan_banner);
    const double without = std::abs(moment(row_of(system, 0.8), 1));
    system.swell = 1.0;
    EXPECT_GT(std::abs(moment(row_of(system, 0.8), 1)), without + 0.02);
}

TEST(Spreading, SwellOfMinusOneComesFromEverywhere) {
    WaveSystem system = with(SpreadingKind::hasselmann);
    system.swell = -1.0;
    for (const double value : row_of(system, 1.0, 1.0, 1.0)) {
        EXPECT_NEAR(value, 1.0 / kTwoPi, 1e-12);
    }
}

TEST(Spreading, OpposingScalesWhatGoesAgainstTheWindOfWavesFromEverywhereToo) {
    WaveSystem phillips;  // both ways
    auto row = row_of(phillips);
    EXPECT_NEAR(row[512] / row[0], 1.0, 1e-12);
    phillips.opposing = 0.07;
    row = row_of(phillips);
    EXPECT_NEAR(row[512] / row[0], 0.07, 1e-12);
    EXPECT_NEAR(integral(row), 1.0, 1e-12);
    WaveSystem system = with(SpreadingKind::hasselmann);
    for (const double swell : {-1.0, -0.3}) {
        system.swell = swell;
        system.opposing = 0.0;
        row = row_of(system);
        EXPECT_NEAR(integral(row), 1.0, 1e-12);
        for (std::size_t j = 257; j < 768; ++j) EXPECT_EQ(row[j], 0.0) << j;
        system.opposing = 0.4;
        row = row_of(system);
        system.opposing = 1.0;
        const auto both = row_of(system);
        EXPECT_NEAR(integral(row), 1.0, 1e-12);
        EXPECT_NEAR(row[512] / row[0], 0.4 * both[512] / both[0], 1e-12);
    }
}

TEST(Spreading, PhillipsAlignmentIsAPowerOfTheCosine) {
    WaveSystem system;
    system.alignment = 6;
    const auto row = row_of(system);
    EXPECT_NEAR(row[100] / row[0], std::pow(std::cos(kTwoPi * 100 / 1024.0), 6.0), 1e-12);
}

TEST(Spreading, MeanDirectionIsTheOneAskedForInAllQuadrants) {
    for (const SpreadingKind kind : kSpreadings) {
        for (double degrees = -170.0; degrees <= 180.0; degrees += 35.0) {
            const auto row = row_of(with(kind), 1.1, 1.0, degrees * kPi / 180.0);
            EXPECT_NEAR(std::remainder(std::arg(moment(row, 1)) * 180.0 / kPi - degrees, 360.0),
                        0.0, 0.05);
        }
    }
}

TEST(Spreading, EnoughDirectionsForOneTenThousandthOfThePeak) {
    for (const SpreadingKind kind : kSpreadings) {
        for (const double swell : {0.0, 1.0}) {
            for (const double wave_age_inverse : {0.4, 0.83, 3.0}) {
                WaveSystem system = with(kind);
                system.swell = swell;
                const auto coarse =
                    static_cast<std::size_t>(directions_needed(system, wave_age_inverse));
                const auto row = row_of(system, 1.0, wave_age_inverse, 0.0, coarse);
                const auto fine = row_of(system, 1.0, wave_age_inverse, 0.0, 2 * coarse);
                for (std::size_t j = 0; j + 1 < row.size(); ++j) {
                    ASSERT_NEAR(0.5 * (row[j] + row[j + 1]), fine[2 * j + 1], 1e-4 * row[0]);
                }
            }
        }
    }
}

TEST(MaximumEntropy, KeepsTheFirstTwoMoments) {
    for (const double r1 : {0.1, 0.5, 0.82}) {
        const std::complex<double> c1 = std::polar(r1, 2.1);
        const std::complex<double> c2 = std::polar(0.6 * r1, 4.0) + 0.3 * c1 * c1;
        const auto row = estimated(c1, c2, Estimator::maximum_entropy, 2048);
        EXPECT_NEAR(std::abs(moment(row, 1) - c1), 0.0, 1e-9);
        EXPECT_NEAR(std::abs(moment(row, 2) - c2), 0.0, 1e-9);
        EXPECT_NEAR(integral(row), 1.0, 1e-12);
    }
}

TEST(MaximumEntropy, IsPositiveAndFiniteForImpossibleMomentsToo) {
    std::vector<double> row(1024);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    for (int i = 0; i < 2000; ++i) {
        for (const Estimator estimator : {Estimator::maximum_entropy, Estimator::fourier}) {
            estimate_row(any(random), any(random), any(random), any(random), estimator, row);
            for (const double value : row) {
                ASSERT_GE(value, 0.0);
                ASSERT_TRUE(std::isfinite(value));
            }
            ASSERT_NEAR(integral(row), 1.0, 1e-12);
        }
    }
}

TEST(MaximumEntropy, MomentsThatNoDistributionHasArePulledToTheNearestThatOneHas) {
    EXPECT_EQ(estimated(0.98, 0.98 * 0.98), estimated(1.0, 0.98 * 0.98))
        << "|c1| = 1 is a line without width";
    // c1 = 0.5: c2 lies within 0.75 of 0.25.
    const auto limit = estimated(0.5, 0.25 - 0.98 * 0.75), beyond = estimated(0.5, -1.0);
    for (std::size_t j = 0; j < limit.size(); ++j) EXPECT_NEAR(limit[j], beyond[j], 1e-9);
}

TEST(MaximumEntropy, NoMomentsMeanNoDirection) {
    for (const double value : estimated(0.0, 0.0)) EXPECT_NEAR(value, 1.0 / kTwoPi, 1e-12);
}

const std::complex<double> kUnknown(std::nan(""), std::nan(""));

TEST(MeanAndSpreadEstimate, IsTheCosinePowerWithThatFirstMoment) {
    for (const double r1 : {0.5, 0.9, 0.99}) {
        const std::complex<double> c1 = std::polar(r1, -2.4);
        const auto row = estimated(c1, kUnknown, Estimator::maximum_entropy, 2048);
        const double s = r1 / (1.0 - r1);
        EXPECT_NEAR(std::abs(moment(row, 1) - c1), 0.0, 1e-6) << r1;
        const double r2 = s * (s - 1.0) / ((s + 1.0) * (s + 2.0));
        EXPECT_NEAR((moment(row, 2) * std::polar(1.0, 4.8)).real(), r2, 1e-6) << r1;
        EXPECT_NEAR(integral(row), 1.0, 1e-12);
        const std::size_t top =
            static_cast<std::size_t>(std::max_element(row.begin(), row.end()) - row.begin());
        EXPECT_NEAR(kTwoPi * static_cast<double>(top) / 2048.0, kTwoPi - 2.4, 0.002)
            << "one crest, at the mean";
    }
}

TEST(MeanAndSpreadEstimate, OfALineOrOfNoDirectionIsFinite) {
    for (const double r1 : {0.0, 1.0, 1.004}) {
        EXPECT_NEAR(integral(estimated(r1, kUnknown, Estimator::fourier)), 1.0, 1e-12) << r1;
    }
}

TEST(FourierEstimate, IsTheTruncatedSeriesWhereThatIsPositive) {
    const auto row = estimated(0.3, 0.1, Estimator::fourier, 256);
    for (std::size_t j = 0; j < row.size(); ++j) {
        const double theta = kTwoPi * static_cast<double>(j) / 256.0;
        EXPECT_NEAR(row[j], (0.5 + 0.3 * std::cos(theta) + 0.1 * std::cos(2.0 * theta)) / kPi,
                    1e-12);
    }
}

}  // namespace
}  // namespace ocean
