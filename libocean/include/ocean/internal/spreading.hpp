// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Directional spreading D(omega, theta): the distribution of the energy of one frequency around the
// mean direction. Each distribution integrates to 1 over the full circle.
#pragma once

#include <span>

#include "ocean/parameters.hpp"

namespace ocean {

/// The max of s in the cos-2s family: a beam 8 degrees wide. Mitsuyasu's s_p grows without bound
/// for swell that has outrun its wind.
inline constexpr double kLargestExponent = 200.0;
/// The max of |c1| of a measured record that has both moments: see directional_estimate.cpp.
inline constexpr double kLargestMoment = 0.98;

/// Returns s of the cos-2s family: s_p x^5 for x <= 1, s_p x^-2.5 above, s_p = 11.5 (U omega_p /
/// g)^-2.5, [Mitsuyasu 1975] eq. 27 to 29. x = omega / omega_p; wave_age_inverse = U omega_p / g.
double mitsuyasu_exponent(double x, double wave_age_inverse);
/// Returns s of the cos-2s family: 6.97 x^4.06 below the peak, 9.77 x^(-2.33 - 1.45 (U omega_p / g
/// - 1.17)) above, [Hasselmann 1980] eq. 4.3.
double hasselmann_exponent(double x, double wave_age_inverse);
/// Returns beta of sech^2(beta theta), [Donelan 1985] eq. 9.2 with the high-frequency tail of
/// [Banner 1990] eq. 4.3.
double donelan_banner_beta(double x);
/// Returns s_xi = 16 tanh(omega_p / omega) xi^2 with the swell xi, [Horvath 2015] eq. 44: it aligns
/// long waves more than short ones.
double swell_exponent(double x, double swell);

/// Returns the circular standard deviation [rad] of a distribution whose first moment has the
/// length r1 (0 .. 1): sqrt(2 (1 - r1)) [Kuik 1988]; sqrt(2) without a preferred direction.
double circular_spread(double r1);

/// Writes one row D(theta_j), theta_j = 2 pi j / row.size(), around mean_direction [rad], so that
/// sum(row) * 2 pi / row.size() == 1 to rounding. x = omega / omega_p. Uses the parameters
/// spreading, swell, opposing and alignment (Phillips) of `system`.
void spreading_row(const WaveSystem& system, double x, double wave_age_inverse,
                   double mean_direction, std::span<double> row);

/// Returns the number of directions, a power of two, that resolves every row of this system to 1e-4
/// of its peak.
int directions_needed(const WaveSystem& system, double wave_age_inverse);

/// Writes a non-negative row D(theta_j) with the given first two moments, travel direction in
/// [rad].
/// maximum_entropy: [Lygre and Krogstad 1986] eq. 13; moments that no distribution can have are
/// moved to the nearest possible ones. fourier: truncated series, negative parts cut off.
/// a2 or b2 = NaN (unknown): |cos(theta/2)|^(2s) about the mean with s = r1 / (1 - r1), which has
/// the first moment r1 [Longuet-Higgins 1963], s at most kLargestExponent. Maximum entropy under a
/// guessed second moment would split a narrow swell in two.
void estimate_row(double a1, double b1, double a2, double b2, Estimator estimator,
                  std::span<double> row);

}  // namespace ocean
