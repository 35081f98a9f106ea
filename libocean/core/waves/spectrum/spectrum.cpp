// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The frequency spectra of [[waves]]: formulas, and the search for peak, support and variance that
// makes each of them a FrequencySpectrum. Next stage: directional_spectrum.cpp.
#include "ocean/internal/spectrum.hpp"

#include <algorithm>
#include <cmath>

#include "ocean/internal/grid.hpp"

namespace ocean {

namespace {

constexpr double kPhillipsConstant = 8.1e-3;

/// Integrates by Gauss's rule of eight points in panels of ln(omega) that are narrower than any
/// peak, on both sides of the kink at `split`.
double integrate(const std::function<double(double)>& density, double low, double split,
                 double high) {
    constexpr double kNode[4] = {0.1834346424956498, 0.5255324099163290, 0.7966664774136267,
                                 0.9602898564975363};
    constexpr double kWeight[4] = {0.3626837833783620, 0.3137066458778873, 0.2223810344533745,
                                   0.1012285362903763};
    constexpr double kPanel = 0.1;
    const auto part = [&](double from, double to) {
        const double length = std::log(to / from);
        const int panels = std::max(1, static_cast<int>(std::ceil(length / kPanel)));
        const double half = 0.5 * length / panels;
        double sum = 0.0;
        for (int i = 0; i < panels; ++i) {
            for (int q = 0; q < 4; ++q) {
                for (const double node : {-kNode[q], kNode[q]}) {
                    const double omega = from * std::exp(half * (2 * i + 1 + node));
                    sum += kWeight[q] * density(omega) * omega;
                }
            }
        }
        return sum * half;
    };
    return part(low, split) + part(split, high);
}

/// Returns the largest density on a grid in ln(omega) a few times finer than any peak, then refined
/// by golden-section steps between its neighbours.
double find_peak(const std::function<double(double)>& density, double low, double high) {
    const auto at = [&](double x) { return density(low * std::exp(x)); };
    const int steps = static_cast<int>(std::ceil(std::log(high / low) / 0.015));
    const double step = std::log(high / low) / steps;
    int best = 0;
    double largest = -1.0;
    for (int i = 0; i <= steps; ++i) {
        const double value = at(step * i);
        if (value > largest) {
            largest = value;
            best = i;
        }
    }
    double a = step * std::max(best - 1, 0);
    double b = step * std::min(best + 1, steps);
    const double ratio = 0.5 * (std::sqrt(5.0) - 1.0);
    double left = b - ratio * (b - a);
    double right = a + ratio * (b - a);
    double at_left = at(left);
    double at_right = at(right);
    for (int i = 0; i < 45; ++i) {
        if (at_left > at_right) {
            b = right;
            right = left;
            at_right = at_left;
            left = b - ratio * (b - a);
            at_left = at(left);
        } else {
            a = left;
            left = right;
            at_left = at_right;
            right = a + ratio * (b - a);
            at_right = at(right);
        }
    }
    return low * std::exp(0.5 * (a + b));
}

}  // namespace

double pierson_moskowitz_peak(double wind_speed_10, double gravity) {
    return std::pow(4.0 * 0.74 / 5.0, 0.25) * gravity / (kWind195 * wind_speed_10);
}

double pierson_moskowitz_density(double omega, double wind_speed_10, double gravity) {
    const double ratio = gravity / (kWind195 * wind_speed_10 * omega);
    return kPhillipsConstant * gravity * gravity * std::pow(omega, -5.0) *
           std::exp(-0.74 * std::pow(ratio, 4.0));
}

double jonswap_peak(double wind_speed, double fetch, double gravity) {
    const double chi = gravity * fetch / (wind_speed * wind_speed);
    return kTwoPi * 3.5 * (gravity / wind_speed) * std::pow(chi, -0.33);
}

namespace {

/// The JONSWAP spectrum of one sea, see jonswap_density.
struct Jonswap {
    double peak;
    double log_enhancement;
    double scale;  // alpha g^2

    Jonswap(double wind_speed, double fetch, double peak_enhancement, double gravity)
        : peak(jonswap_peak(wind_speed, fetch, gravity)),
          log_enhancement(std::log(peak_enhancement)) {
        const double chi = gravity * fetch / (wind_speed * wind_speed);
        scale = 0.076 * std::pow(chi, -0.22) * gravity * gravity;
    }

    double operator()(double omega) const {
        const double sigma = omega <= peak ? 0.07 : 0.09;
        const double distance = (omega - peak) / (sigma * peak);
        const double r = std::exp(-0.5 * distance * distance);
        const double square = omega * omega;
        const double ratio = peak * peak / square;
        return scale / (square * square * omega) *
               std::exp(log_enhancement * r - 1.25 * ratio * ratio);
    }
};

}  // namespace

double jonswap_density(double omega, double wind_speed, double fetch, double peak_enhancement,
                       double gravity) {
    return Jonswap(wind_speed, fetch, peak_enhancement, gravity)(omega);
}

double finite_depth_factor(double omega, double depth, double gravity) {
    const Water gravity_waves{.depth = depth, .gravity = gravity, .surface_tension = 0.0};
    const double kd = Dispersion(gravity_waves).wavenumber(omega) * depth;
    if (!(kd < 20.0)) return 1.0;
    const double tangent = std::tanh(kd);
    return tangent * tangent / (1.0 + 2.0 * kd / std::sinh(2.0 * kd));
}

double phillips_wavenumber_density(double k, double wind_speed, double amplitude,
                                   double cutoff_wavelength, double gravity) {
    const double longest = k * wind_speed * wind_speed / gravity;
    const double shortest = k * cutoff_wavelength / kTwoPi;
    return 0.5 * kPhillipsConstant * amplitude * std::pow(k, -3.0) *
           std::exp(-1.0 / (longest * longest) - shortest * shortest);
}

namespace {

/// Wind below which a sea is flat [m/s]: its waves would be lower than two micrometres. The scales
/// of a spectrum are powers of the wind and exceed all numbers when a take lets it glide from 0.
constexpr double kCalm = 1e-6;

}  // namespace

DirectionLaw direction_law(SpectrumKind kind) {
    switch (kind) {
        case SpectrumKind::phillips:
            return DirectionLaw::alignment;
        case SpectrumKind::pierson_moskowitz:
        case SpectrumKind::jonswap:
        case SpectrumKind::tma:
        case SpectrumKind::measured:
            break;
    }
    return DirectionLaw::spreading;
}

FrequencySpectrum make_frequency_spectrum(const WaveSystem& system, const Water& water,
                                          double highest) {
    FrequencySpectrum result;
    const double wind = system.wind();
    const double g = water.gravity;
    if (wind < kCalm) return result;

    switch (system.spectrum) {
        case SpectrumKind::pierson_moskowitz:
            result.parameter_peak = pierson_moskowitz_peak(wind, g);
            result.density = [=](double w) { return pierson_moskowitz_density(w, wind, g); };
            break;
        case SpectrumKind::jonswap:
        case SpectrumKind::tma:
            result.parameter_peak = jonswap_peak(wind, system.fetch, g);
            result.density = Jonswap(wind, system.fetch, system.peak_enhancement, g);
            if (system.spectrum == SpectrumKind::tma && std::isfinite(water.depth)) {
                result.density = [deep = result.density, depth = water.depth, g](double w) {
                    return deep(w) * finite_depth_factor(w, depth, g);
                };
            }
            break;
        case SpectrumKind::phillips:
            // S(omega) = S(k) / c_g; its peak is the peak of k^-3 exp(-(kL)^-2) times omega/g in
            // deep water: k = sqrt(4/5) / L.
            result.parameter_peak =
                Dispersion(water).angular_frequency(std::sqrt(0.8) * g / (wind * wind));
            result.density = [=, dispersion = Dispersion(water), amplitude = system.amplitude,
                              cutoff = system.cutoff_wavelength](double w) {
                const double k = dispersion.wavenumber(w);
                return phillips_wavenumber_density(k, wind, amplitude, cutoff, g) /
                       dispersion.group_velocity(k);
            };
            break;
        case SpectrumKind::measured:
            return result;
    }
    // Below a fifth of the peak every spectrum is under e^-700 or, in shallow water, where
    // Phillips' lower flank is drawn out, under 1e-9 of the peak.
    result.lowest = 0.1 * result.parameter_peak;
    result.highest = std::max(highest, 8.0 * result.parameter_peak);
    result.peak = find_peak(result.density, result.lowest, result.highest);
    result.m0 = integrate(result.density, result.lowest, result.parameter_peak, result.highest);
    return result;
}

}  // namespace ocean
