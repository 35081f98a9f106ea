// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Directions of a measured sea: from the one or two known Fourier moments of a frequency to a
// non-negative distribution over the circle.
#include <algorithm>
#include <cmath>
#include <complex>

#include "ocean/internal/grid.hpp"
#include "ocean/internal/spreading.hpp"

namespace ocean {

namespace {

using Complex = std::complex<double>;

// A distribution on the circle obeys |c1| < 1 and |c2 - c1^2| <= 1 - |c1|^2 (its Toeplitz matrix is
// positive). Noisy moments, or moments printed with two digits, may violate this: they are moved to
// the nearest point inside. kLargestMoment keeps the narrowest peak about 12 degrees wide.
void make_possible(Complex& c1, Complex& c2) {
    if (std::abs(c1) > kLargestMoment) c1 *= kLargestMoment / std::abs(c1);
    const double radius = kLargestMoment * (1.0 - std::norm(c1));
    const Complex offset = c2 - c1 * c1;
    if (std::abs(offset) > radius) c2 = c1 * c1 + offset * (radius / std::abs(offset));
}

void cosine_2s_row(Complex c1, std::span<double> row) {
    const double r1 = std::abs(c1);
    const double s = r1 < 1.0 ? std::min(r1 / (1.0 - r1), kLargestExponent) : kLargestExponent;
    for (std::size_t j = 0; j < row.size(); ++j) {
        const double theta = kTwoPi * static_cast<double>(j) / static_cast<double>(row.size());
        row[j] = std::pow(std::abs(std::cos(0.5 * (theta - std::arg(c1)))), 2.0 * s);
    }
}

void moments_row(Complex c1, Complex c2, Estimator estimator, std::span<double> row) {
    make_possible(c1, c2);
    // phi_1, phi_2 of the second-order autoregressive process that has these moments.
    const Complex phi1 = (c1 - c2 * std::conj(c1)) / (1.0 - std::norm(c1));
    const Complex phi2 = c2 - c1 * phi1;
    for (std::size_t j = 0; j < row.size(); ++j) {
        const double theta = kTwoPi * static_cast<double>(j) / static_cast<double>(row.size());
        const Complex turn1 = std::polar(1.0, -theta);
        const Complex turn2 = std::polar(1.0, -2.0 * theta);
        switch (estimator) {
            case Estimator::maximum_entropy:
                row[j] = 1.0 / std::norm(1.0 - phi1 * turn1 - phi2 * turn2);
                break;
            case Estimator::fourier:
                row[j] = std::max(0.0, 0.5 + (c1 * turn1).real() + (c2 * turn2).real());
                break;
        }
    }
}

}  // namespace

void estimate_row(double a1, double b1, double a2, double b2, Estimator estimator,
                  std::span<double> row) {
    if (std::isnan(a2 + b2)) {
        cosine_2s_row({a1, b1}, row);
    } else {
        moments_row({a1, b1}, {a2, b2}, estimator, row);
    }
    double sum = 0.0;
    for (const double value : row) sum += value;
    const double scale = static_cast<double>(row.size()) / (kTwoPi * sum);
    for (double& value : row) value *= scale;
}

}  // namespace ocean
