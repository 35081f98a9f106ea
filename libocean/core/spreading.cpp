// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Directional spreading functions and their normalisation. Between spectrum.cpp, which says how
// much energy a frequency has, and directional_spectrum.cpp, which puts both into the table.
#include "ocean/spreading.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "ocean/grid.hpp"

namespace ocean {

double mitsuyasu_exponent(double x, double wave_age_inverse) {
    const double at_peak = 11.5 * std::pow(wave_age_inverse, -2.5);
    return at_peak * (x <= 1.0 ? std::pow(x, 5.0) : std::pow(x, -2.5));
}

double hasselmann_exponent(double x, double wave_age_inverse) {
    if (x <= 1.0) return 6.97 * std::pow(x, 4.06);
    return 9.77 * std::pow(x, -2.33 - 1.45 * (wave_age_inverse - 1.17));
}

double donelan_banner_beta(double x) {
    if (x < 0.95) return 2.61 * std::pow(x, 1.3);
    if (x < 1.6) return 2.28 * std::pow(x, -1.3);
    return std::pow(10.0, -0.4 + 0.8393 * std::exp(-0.567 * std::log(x * x)));
}

double swell_exponent(double x, double swell) {
    return 16.0 * std::tanh(1.0 / x) * swell * swell;
}

double circular_spread(double r1) {
    return std::sqrt(2.0 * std::clamp(1.0 - r1, 0.0, 1.0));
}

double cosine_2s_normalisation(double s) {
    // ln Q = (2s-1) ln 2 - ln pi + 2 ln Gamma(s+1) - ln Gamma(2s+1): tgamma overflows from s = 86.
    return std::exp((2.0 * s - 1.0) * std::log(2.0) - std::log(kPi) + 2.0 * std::lgamma(s + 1.0) -
                    std::lgamma(2.0 * s + 1.0));
}

namespace {

/// The exponent of |cos(theta/2)|^2 that the system's base distribution has at x; 0 if it is not of
/// that family.
double base_exponent(const WaveSystem& system, double x, double wave_age_inverse) {
    if (system.spectrum == SpectrumKind::phillips) return 0.0;
    switch (system.spreading) {
        case SpreadingKind::mitsuyasu:
            return std::min(mitsuyasu_exponent(x, wave_age_inverse), kLargestExponent);
        case SpreadingKind::hasselmann:
            return std::min(hasselmann_exponent(x, wave_age_inverse), kLargestExponent);
        case SpreadingKind::cosine_squared:
        case SpreadingKind::donelan_banner:
            break;
    }
    return 0.0;
}

/// The base distribution without the |cos(theta/2)|^(2s) part, not normalised.
double base_shape(const WaveSystem& system, double beta, double theta) {
    const double cosine = std::cos(theta);
    if (system.spectrum == SpectrumKind::phillips) {
        return std::pow(std::abs(cosine), system.alignment);
    }
    switch (system.spreading) {
        case SpreadingKind::cosine_squared:
            return cosine > 0.0 ? cosine * cosine : 0.0;
        case SpreadingKind::donelan_banner: {
            const double sech = 1.0 / std::cosh(beta * theta);
            return sech * sech;
        }
        case SpreadingKind::mitsuyasu:
        case SpreadingKind::hasselmann:
            break;
    }
    return 1.0;
}

void scale_to_unit_integral(std::span<double> row) {
    double sum = 0.0;
    for (double value : row) sum += value;
    const double scale = static_cast<double>(row.size()) / (kTwoPi * sum);
    for (double& value : row) value *= scale;
}

}  // namespace

void spreading_row(const WaveSystem& system, double x, double wave_age_inverse,
                   double mean_direction, std::span<double> row) {
    const double swell = std::max(system.swell, 0.0);
    const double exponent = base_exponent(system, x, wave_age_inverse) + swell_exponent(x, swell);
    const double beta = donelan_banner_beta(x);
    const double step = kTwoPi / static_cast<double>(row.size());
    for (std::size_t j = 0; j < row.size(); ++j) {
        const double theta = std::remainder(step * static_cast<double>(j) - mean_direction, kTwoPi);
        const double cosine = std::cos(0.5 * theta);
        double value = base_shape(system, beta, theta);
        if (exponent > 0.0) value *= std::pow(cosine * cosine, exponent);
        if (std::abs(theta) > 0.5 * kPi) value *= system.opposing;
        row[j] = value;
    }
    scale_to_unit_integral(row);
    const double uniform = std::max(-system.swell, 0.0);  // swell < 0: towards no direction at all
    for (double& value : row) value += uniform * (1.0 / kTwoPi - value);
}

int directions_needed(const WaveSystem& system, double wave_age_inverse) {
    // Linear interpolation between columns h apart errs by h^2/8 of the second derivative, which at
    // the top of |cos(theta/2)|^(2s) is s/2 of the peak, and of sech^2(beta theta) 2 beta^2.
    const double swell = std::max(system.swell, 0.0);
    double bend = 0.5 * (base_exponent(system, 1.0, wave_age_inverse) + 16.0 * swell * swell);
    if (system.spectrum == SpectrumKind::phillips) {
        bend += system.alignment;
    } else if (system.spreading == SpreadingKind::hasselmann) {
        bend = std::max(bend, 0.5 * (9.77 + 16.0 * swell * swell));
    } else {
        bend += 2.0 * 2.44 * 2.44;
    }
    const double step = std::sqrt(8.0 * 0.8e-4 / bend);
    const auto wanted = static_cast<unsigned>(std::min(kTwoPi / step, 8192.0));
    return static_cast<int>(std::clamp(std::bit_ceil(wanted), 512u, 8192u));
}

}  // namespace ocean
