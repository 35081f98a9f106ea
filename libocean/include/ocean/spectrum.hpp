// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Frequency spectra S(omega) of the parametric wave systems: the formulas, one function each.
// S is a one-sided variance density in m^2 s/rad: its integral is the variance m0, Hs = 4 sqrt(m0).
#pragma once

#include <functional>

#include "ocean/dispersion.hpp"

namespace ocean {

/// U(19.5 m) = 1.026 U10: logarithmic wind profile over the sea. Pierson and Moskowitz measured
/// at 19.5 m, our wind_speed is at 10 m.
inline constexpr double kWind195 = 1.026;

/// S = alpha g^2 omega^-5 exp(-0.74 (g / (U omega))^4), alpha = 8.1e-3, U at 19.5 m.
/// [Pierson and Moskowitz 1964] eq. 15. Closed form m0 = alpha U^4 / (4 * 0.74 g^2).
double pierson_moskowitz_density(double omega, double wind_speed_10, double gravity);
/// Its peak, (4 * 0.74 / 5)^(1/4) g / U.
double pierson_moskowitz_peak(double wind_speed_10, double gravity);

/// omega_p = 2 pi 3.5 (g / U) chi^-0.33, chi = g F / U^2, F in metres. [Hasselmann 1973] sec. 2.
double jonswap_peak(double wind_speed, double fetch, double gravity);
/// S = alpha g^2 omega^-5 exp(-5/4 (omega_p/omega)^4) gamma^r, alpha = 0.076 chi^-0.22.
/// [Hasselmann 1973] eq. 2.4.1. gamma = 1 is the Pierson-Moskowitz shape.
double jonswap_density(double omega, double wind_speed, double fetch, double peak_enhancement,
                       double gravity);

/// Phi = tanh^2(k d) / (1 + 2 k d / sinh(2 k d)) with k from gravity waves at that depth.
/// [Kitaigorodskii 1975] eq. 10, exact. 1 in deep water, (omega^2 d / g)/2 in shallow.
double finite_depth_factor(double omega, double depth, double gravity);

/// Variance density over the wavenumber magnitude, all directions, m^3:
/// (alpha/2) A k^-3 exp(-1/(k L)^2) exp(-(k l)^2), L = U^2/g, l = cutoff_wavelength / 2 pi.
/// [Phillips 1958], [Tessendorf 2001] eq. 40, with A = 1 at Phillips' constant alpha = 8.1e-3.
double phillips_wavenumber_density(double k, double wind_speed, double amplitude,
                                   double cutoff_wavelength, double gravity);

/// A frequency spectrum with what the other stages ask of it.
struct FrequencySpectrum {
    std::function<double(double omega)> density;  // m^2 s/rad; 0 outside [lowest, highest]
    double parameter_peak = 0.0;  // omega_p of the formula, rad/s: what spreading refers to
    double peak = 0.0;            // where the density is largest, rad/s; 0 for a flat sea
    double lowest = 0.0;          // support; the tail beyond `highest` is not represented
    double highest = 0.0;
    double m0 = 0.0;  // integral over the support, m^2

    bool flat() const { return m0 <= 0.0; }
};

/// Before any rescaling. `highest` bounds the table. Not for measured systems.
FrequencySpectrum make_frequency_spectrum(const WaveSystem& system, const Water& water,
                                          double highest);

}  // namespace ocean
