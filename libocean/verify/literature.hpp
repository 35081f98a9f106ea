// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The equations of the literature, written apart from the library's, so that a slip in one of them
// shows. SI units; g = 9.81 m/s^2.
#pragma once

#include <cmath>

namespace ocean::verify {

inline constexpr double kPi = 3.14159265358979323846;
inline constexpr double kG = 9.81;

/// Returns the integral of f from a to b by Simpson's rule on `steps` (even) intervals.
template <typename Function>
double integral(const Function& f, double a, double b, int steps = 4000) {
    const double h = (b - a) / steps;
    double sum = f(a) + f(b);
    for (int i = 1; i < steps; ++i) sum += (i % 2 == 1 ? 4.0 : 2.0) * f(a + h * i);
    return sum * h / 3.0;
}

/// Returns omega of omega^2 = (g k + (sigma/rho) k^3) tanh k d, sigma = 0.074 N/m, rho = 1000
/// kg/m^3 [rad/s].
double angular_frequency(double k, double depth);
/// Returns k of omega^2 = g k tanh(k d) [rad/m], by bisection.
double wavenumber(double omega, double depth);
/// Returns d omega / dk of that wave [m/s].
double group_speed(double omega, double depth);

/// [Hasselmann 1973]: S = alpha g^2 omega^-5 exp(-5/4 (omega_p/omega)^4) gamma^r,
/// omega_p = 7 pi (g/U) chi^-0.33, alpha = 0.076 chi^-0.22, chi = g F/U^2,
/// r = exp(-(omega/omega_p - 1)^2/(2 sigma^2)), sigma = 0.07 up to the peak, 0.09 beyond.
struct Jonswap {
    double wind, fetch, gamma = 3.3;

    double chi() const { return kG * fetch / (wind * wind); }
    double peak() const { return 7.0 * kPi * kG / wind * std::pow(chi(), -0.33); }
    double alpha() const { return 0.076 * std::pow(chi(), -0.22); }
    /// Returns S [m^2 s/rad].
    double density(double omega) const;
    /// Returns the integral of f(omega) S over all frequencies.
    template <typename Function>
    double moment(const Function& f) const {
        const auto term = [&](double logarithm) {
            const double omega = std::exp(logarithm);
            return omega * f(omega) * density(omega);
        };
        // The width of the peak changes there.
        const double middle = std::log(peak());
        return integral(term, middle - 1.2, middle) + integral(term, middle, middle + 6.0);
    }
};

/// [Kitaigorodskii 1975]: the factor of TMA, tanh^2 kd/(1 + 2 kd/sinh 2 kd).
double finite_depth_share(double omega, double depth);

}  // namespace ocean::verify
