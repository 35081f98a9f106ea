// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Directional spreading functions and their normalisation. This is the stage between spectrum.cpp,
// which states the energy of a frequency, and directional_spectrum.cpp, which writes both into the
// table.
#include "ocean/internal/spreading.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "ocean/internal/grid.hpp"
#include "ocean/internal/spectrum.hpp"
#include "waves/spectrum/spreading_rows.hpp"

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

namespace {

bool is_aligned(const WaveSystem& system) {
    return direction_law(system.spectrum) == DirectionLaw::alignment;
}

/// Returns the exponent of |cos(theta/2)|^2 in the system's base distribution at x; 0 for a
/// distribution of another family.
double base_exponent(const WaveSystem& system, double x, double wave_age_inverse) {
    if (is_aligned(system)) return 0.0;
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

/// Returns the part of the distribution that does not depend on the frequency.
double base_shape(const WaveSystem& system, double theta) {
    const double cosine = std::cos(theta);
    if (is_aligned(system)) return std::pow(std::abs(cosine), system.alignment);
    if (system.spreading == SpreadingKind::cosine_squared) {
        return cosine > 0.0 ? cosine * cosine : 0.0;
    }
    return 1.0;
}

bool is_donelan_banner(const WaveSystem& system) {
    return !is_aligned(system) && system.spreading == SpreadingKind::donelan_banner;
}

/// Returns e^x for x <= 0 to 1e-11, 0 below -600: the series of e^r, |r| <= ln(2)/2, even and odd
/// terms side by side, times a power of two that is put into the exponent's bits. The compiler
/// vectorises loops over it.
inline double exponential(double x) {
    constexpr double kRounding = 6755399441055744.0;  // 1.5 * 2^52: adding it rounds to whole
    const double shifted = x * 1.4426950408889634 + kRounding;
    const double power = shifted - kRounding;
    // ln(2) in two parts; the first ends in zeros, so that its product with `power` is exact.
    const double r = (x - power * 0.6931471803691238) - power * 1.9082149292705877e-10;
    const double q = r * r;
    double even = q * (1.0 / 40320.0) + 1.0 / 720.0;
    double odd = q * (1.0 / 362880.0) + 1.0 / 5040.0;
    even = even * q + 1.0 / 24.0;
    odd = odd * q + 1.0 / 120.0;
    even = even * q + 0.5;
    odd = odd * q + 1.0 / 6.0;
    even = even * q + 1.0;
    odd = odd * q + 1.0;
    const std::uint64_t exponent =
        (std::bit_cast<std::uint64_t>(shifted) << 52) + std::bit_cast<std::uint64_t>(1.0);
    return x > -600.0 ? (even + r * odd) * std::bit_cast<double>(exponent) : 0.0;
}

void scale_to_unit_integral(std::span<double> row) {
    const double sum = row_total(row);
    const double scale = static_cast<double>(row.size()) / (kTwoPi * sum);
    for (double& value : row) value *= scale;
}

}  // namespace

double row_total(std::span<const double> row) {
    double part[8] = {};
    std::size_t j = 0;
    for (; j + 8 <= row.size(); j += 8) {
        for (std::size_t l = 0; l < 8; ++l) part[l] += row[j + l];
    }
    for (; j < row.size(); ++j) part[0] += row[j];
    return ((part[0] + part[4]) + (part[1] + part[5])) +
           ((part[2] + part[6]) + (part[3] + part[7]));
}

SpreadingRows::SpreadingRows(const WaveSystem& system, double wave_age_inverse,
                             double mean_direction, std::size_t columns)
    : system_(system), wave_age_inverse_(wave_age_inverse) {
    const double step = kTwoPi / static_cast<double>(columns);
    for (std::size_t j = 0; j < columns; ++j) {
        const double theta = std::remainder(step * static_cast<double>(j) - mean_direction, kTwoPi);
        const double cosine = std::cos(0.5 * theta);
        const double kept = std::abs(theta) > 0.5 * kPi ? system.opposing : 1.0;
        // A uniform part is reduced too, after it has been added.
        shape_.push_back(base_shape(system, theta) * (mixes_with_uniform() ? 1.0 : kept));
        kept_.push_back(kept);
        log_cosine_.push_back(std::log(std::max(cosine * cosine, 1e-300)));
        distance_.push_back(std::abs(theta));
    }
    const bool has_one_shape =
        is_aligned(system_) || system_.spreading == SpreadingKind::cosine_squared;
    if (!has_one_shape || system_.swell != 0.0) return;
    same_everywhere_ = shape_;
    scale_to_unit_integral(same_everywhere_);
}

void SpreadingRows::fill(double x, std::span<double> row) const {
    if (!same_everywhere_.empty()) {
        std::ranges::copy(same_everywhere_, row.begin());
        return;
    }
    const double swell = std::max(system_.swell, 0.0);
    const double exponent = base_exponent(system_, x, wave_age_inverse_) + swell_exponent(x, swell);
    const double* shape = shape_.data();
    const double* log_cosine = log_cosine_.data();
    const double* distance = distance_.data();
    double* values = row.data();
    if (exponent > 0.0) {
        for (std::size_t j = 0; j < row.size(); ++j) {
            values[j] = shape[j] * exponential(exponent * log_cosine[j]);
        }
    } else {
        std::copy(shape_.begin(), shape_.end(), row.begin());
    }
    if (is_donelan_banner(system_)) {
        const double beta = donelan_banner_beta(x);
        for (std::size_t j = 0; j < row.size(); ++j) {
            // sech^2(y) = 4 e^-2y / (1 + e^-2y)^2
            const double decay = exponential(-2.0 * beta * distance[j]);
            values[j] *= 4.0 * decay / ((1.0 + decay) * (1.0 + decay));
        }
    }
    scale_to_unit_integral(row);
    if (!mixes_with_uniform()) return;
    const double uniform = -system_.swell;  // towards no direction at all
    for (double& value : row) value += uniform * (1.0 / kTwoPi - value);
    if (system_.opposing == 1.0) return;
    for (std::size_t j = 0; j < row.size(); ++j) values[j] *= kept_[j];
    scale_to_unit_integral(row);
}

void spreading_row(const WaveSystem& system, double x, double wave_age_inverse,
                   double mean_direction, std::span<double> row) {
    SpreadingRows(system, wave_age_inverse, mean_direction, row.size()).fill(x, row);
}

int directions_needed(const WaveSystem& system, double wave_age_inverse) {
    // Linear interpolation between columns h apart errs by h^2/8 of the second derivative, which at
    // the top of |cos(theta/2)|^(2s) is s/2 of the peak, and of sech^2(beta theta) 2 beta^2.
    const double swell = std::max(system.swell, 0.0);
    double bend = 0.5 * (base_exponent(system, 1.0, wave_age_inverse) + 16.0 * swell * swell);
    if (is_aligned(system)) {
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
