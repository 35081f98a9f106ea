// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Frequency spectra S(omega) of the parametric wave systems: the formulas, one function each.
//
// Symbols of all of them:
// - S: one-sided variance density [m^2 s/rad]. Its integral is the variance m0; Hs = 4 sqrt(m0).
// - omega: angular frequency [rad/s], > 0; S is largest at omega_p.
// - U: wind speed at a height of 10 m [m/s], > 0.
// - F: fetch [m], the distance over which the wind has blown.
// - g: acceleration of gravity [m/s^2].
// - d: depth [m].
// - alpha: Phillips' constant. Short waves have the energy alpha g^2 omega^-5.
#pragma once

#include <functional>

#include "ocean/internal/dispersion.hpp"

namespace ocean {

/// The wind at 19.5 m over U, the wind at 10 m, by the logarithmic wind profile over the sea.
inline constexpr double kWind195 = 1.026;

/// Returns the spectrum of Pierson and Moskowitz, for a fully developed sea: the wind has blown so
/// far and so long that the waves grow no more.
///     S = alpha g^2 omega^-5 exp(-0.74 (g / (U' omega))^4),   alpha = 8.1e-3,   U' = U(19.5 m)
/// [Pierson and Moskowitz 1964] eq. 15; the wind of their weather ships was measured at 19.5 m.
/// Range: winds of 10 to 20 m/s, as measured; the form has no scale but U'^2 / g.
/// Limits: omega >> g/U' gives alpha g^2 omega^-5; omega -> 0 gives 0, faster than any power.
/// The integral is m0 = alpha U'^4 / (4 * 0.74 g^2).
/// Tests: Spectrum.PiersonMoskowitzAt17MetresPerSecondIs6_1643Metres,
/// PiersonMoskowitzVarianceIsItsClosedForm.
double pierson_moskowitz_density(double omega, double wind_speed_10, double gravity);
/// Returns omega_p = (4 * 0.74 / 5)^(1/4) g / U', where dS/domega = 0.
/// Test: Spectrum.PiersonMoskowitzPeakIsThatOfTheWindAt19_5Metres.
double pierson_moskowitz_peak(double wind_speed_10, double gravity);

/// The JONSWAP spectrum, for a sea that grows under the wind along the fetch. Its peak is narrower
/// and higher than that of a fully developed sea:
///     S = alpha g^2 omega^-5 exp(-5/4 (omega_p / omega)^4) gamma^r
///     r = exp(-(omega - omega_p)^2 / (2 sigma^2 omega_p^2))
///     alpha = 0.076 chi^-0.22,   omega_p = 2 pi 3.5 (g / U) chi^-0.33,   chi = g F / U^2
/// chi    fetch in units of the wind's own length U^2 / g, a pure number; F in metres, not km
/// gamma  peak_enhancement: S(omega_p) over that of gamma = 1; 3.3 on average, 1 .. 7 in the data
/// sigma  width of the peak in units of omega_p: 0.07 for omega <= omega_p, 0.09 above
/// [Hasselmann 1973] eq. 2.4.1, the powers of chi from their section 2.
/// Range: chi up to some 1e4. From 1.9e4 on (U = 10 m/s: 190 km) omega_p lies below that of
/// pierson_moskowitz_peak, and with gamma = 3.3 the variance is larger from 1.2e4 on (120 km),
/// though nothing grows any more; the formula does not stop there. full_development_warnings()
/// reports such seas.
/// Limits: gamma = 1 is the shape of Pierson and Moskowitz, m0 = alpha g^2 / (5 omega_p^4);
/// omega >> omega_p gives alpha g^2 omega^-5; omega -> 0 gives 0.
/// Tests: Spectrum.JonswapGoldenPeaksAndHeights, JonswapLimits,
/// JonswapPeakIsNarrowerBelowThanAbove.
double jonswap_density(double omega, double wind_speed, double fetch, double peak_enhancement,
                       double gravity);
/// Returns the peak frequency omega_p of jonswap_density.
double jonswap_peak(double wind_speed, double fetch, double gravity);

/// Returns the factor 0 .. 1 by which shallow water reduces the energy of each frequency:
///     Phi = tanh^2(k d) / (1 + 2 k d / sinh(2 k d)),   omega^2 = g k tanh(k d)
/// k      wavenumber of a gravity wave of that frequency at that depth, rad/m
/// [Kitaigorodskii 1975] eq. 10, exact and not its usual two pieces. JONSWAP times Phi is TMA, for
/// wind seas over a flat bottom [Bouws 1985].
/// Limits: k d >> 1 gives 1; k d << 1 gives omega^2 d / (2 g).
/// Tests: Spectrum.FiniteDepthFactorIsTheExactOne,
/// TmaIsJonswapTimesTheDepthFactorAndEqualInDeepWater.
double finite_depth_factor(double omega, double depth, double gravity);

/// Returns Phillips' spectrum as the variance density over the magnitude k of the wavenumber, all
/// directions together [m^3]:
///     P = (alpha/2) A k^-3 exp(-1 / (k L)^2) exp(-(k l)^2),   alpha = 8.1e-3
/// A      amplitude, a pure number: 1 is Phillips' constant
/// L      U^2 / g, m: about the longest wave of this wind
/// l      cutoff_wavelength / 2 pi, m: waves of the cut-off's length keep 1/e of their energy
/// S = P(k) / c_g with the group velocity c_g, so that S domega = P dk.
/// [Phillips 1958] for the power, [Tessendorf 2001] eq. 40 for the two flanks.
/// Range: a shape for pictures; no sea was measured for it.
/// Limits: k L >> 1, k l << 1 gives (alpha/2) A k^-3, Phillips' range; k -> 0 gives 0. With l = 0
/// the integral is m0 = A alpha L^2 / 4.
/// Tests: Spectrum.PhillipsVarianceIsItsClosedForm,
/// PhillipsCutoffIsTheWavelengthOfOneEthOfTheEnergy.
double phillips_wavenumber_density(double k, double wind_speed, double amplitude,
                                   double cutoff_wavelength, double gravity);

/// The parameter that sets the directions of a kind of spectrum if no record has measured them.
enum class DirectionLaw { spreading, alignment };
DirectionLaw direction_law(SpectrumKind kind);

/// A frequency spectrum with the properties that the other stages read.
struct FrequencySpectrum {
    std::function<double(double omega)> density;  // [m^2 s/rad]; 0 outside [lowest, highest]
    double parameter_peak = 0.0;  // omega_p of the formula [rad/s], read by the spreading
    double peak = 0.0;            // where the density is largest [rad/s]; 0 for a flat sea
    double lowest = 0.0;          // support [rad/s]; the tail above `highest` is not represented
    double highest = 0.0;
    double m0 = 0.0;  // integral over the support [m^2]

    bool flat() const { return m0 <= 0.0; }
};

/// Returns the spectrum of a parametric system, before it is scaled to a given height. `highest`
/// bounds the table [rad/s]. Measured systems have no such spectrum.
FrequencySpectrum make_frequency_spectrum(const WaveSystem& system, const Water& water,
                                          double highest);

}  // namespace ocean
