// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "literature.hpp"

namespace ocean::verify {

double angular_frequency(double k, double depth) {
    return std::sqrt((kG * k + 0.074e-3 * k * k * k) * std::tanh(k * depth));
}

double wavenumber(double omega, double depth) {
    const double deep = omega * omega / kG;
    if (std::isinf(depth)) return deep;
    double low = deep, high = deep + omega / std::sqrt(kG * depth);
    for (int i = 0; i < 200; ++i) {
        const double k = 0.5 * (low + high);
        (kG * k * std::tanh(k * depth) < omega * omega ? low : high) = k;
    }
    return low;
}

double group_speed(double omega, double depth) {
    const double k = wavenumber(omega, depth);
    const double q = 2.0 * k * depth;
    return omega / k * 0.5 * (1.0 + (q < 100.0 ? q / std::sinh(q) : 0.0));
}

double Jonswap::density(double omega) const {
    const double x = omega / peak();
    const double sigma = x <= 1.0 ? 0.07 : 0.09;
    const double r = std::exp(-0.5 * std::pow((x - 1.0) / sigma, 2.0));
    return alpha() * kG * kG * std::pow(omega, -5.0) * std::exp(-1.25 * std::pow(x, -4.0)) *
           std::pow(gamma, r);
}

double finite_depth_share(double omega, double depth) {
    const double q = wavenumber(omega, depth) * depth;
    if (q > 50.0) return 1.0;
    return std::pow(std::tanh(q), 2.0) / (1.0 + 2.0 * q / std::sinh(2.0 * q));
}

}  // namespace ocean::verify
