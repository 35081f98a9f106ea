// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Fits a law to rings: see law_fit.hpp.
//
// The log of a ring's density scatters with a variance of 1 / count, and no simple law is closer to
// land than some per cent, so a ring weighs 1 / (1 / count + 0.1^2).
#include "law_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "nelder_mead.hpp"
#include "ocean/grid.hpp"
#include "ocean/terrain_law.hpp"

namespace ocean {
namespace {

constexpr double kLawScatter = 0.1;  // of log S
constexpr Bounds kExponents{0.2, 4.5};
constexpr Bounds kRidgeGain{0.05, 50.0};
constexpr Bounds kRidgeWidth{0.15, 2.0};  // [octaves]

/// A parameter of the fit: how it is named, bounded, and set.
struct FitParameter {
    const char* name;
    Bounds bounds;
    bool is_logarithmic;
    void (*set)(Terrain&, double);
};

std::vector<FitParameter> parameters_of(FitLaw law, bool ridge, const Bounds& wavelengths) {
    std::vector<FitParameter> all = {
        {"beta", kExponents, false, [](Terrain& t, double value) { t.beta = value; }}};
    if (law != FitLaw::broken) return all;
    all.push_back({"break_wavelength", wavelengths, true,
                   [](Terrain& t, double value) { t.breaks[0][0] = value; }});
    all.push_back({"break_beta", kExponents, false,
                   [](Terrain& t, double value) { t.breaks[0][1] = value; }});
    if (!ridge) return all;
    all.push_back({"ridge_wavelength", wavelengths, true,
                   [](Terrain& t, double value) { t.ridge_wavelength = value; }});
    all.push_back(
        {"ridge_gain", kRidgeGain, true, [](Terrain& t, double value) { t.ridge_gain = value; }});
    all.push_back({"ridge_width", kRidgeWidth, true,
                   [](Terrain& t, double value) { t.ridge_width = value; }});
    return all;
}

class RingResiduals {
  public:
    RingResiduals(std::span<const Ring> rings, const Terrain& terrain,
                  const std::vector<FitParameter>& parameters)
        : terrain_(terrain), parameters_(parameters) {
        for (const Ring& ring : rings) {
            if (ring.density > 0.0) rings_.push_back(ring);
        }
    }

    void set(Terrain& terrain, std::span<const double> place) const {
        for (std::size_t i = 0; i < parameters_.size(); ++i) {
            const double value = parameters_[i].is_logarithmic ? std::exp(place[i]) : place[i];
            parameters_[i].set(terrain, value);
        }
    }
    /// Returns the level that suits a law best.
    double level(const TerrainLaw& law) const {
        double sum = 0.0, weight = 0.0;
        for (const Ring& ring : rings_) {
            sum += weight_of(ring) * difference(ring, law);
            weight += weight_of(ring);
        }
        return sum / weight;
    }
    double sum_of_squares(std::span<const double> place) {
        set(terrain_, place);
        const TerrainLaw law(terrain_);
        const double best = level(law);
        double sum = 0.0;
        for (const Ring& ring : rings_) {
            const double residual = difference(ring, law) - best;
            sum += weight_of(ring) * residual * residual;
        }
        return sum;
    }

  private:
    static double weight_of(const Ring& ring) {
        return 1.0 / (1.0 / ring.count + kLawScatter * kLawScatter);
    }
    static double difference(const Ring& ring, const TerrainLaw& law) {
        return std::log(ring.density) - std::log(law.density(ring.wavenumber, 0.0));
    }

    Terrain terrain_;
    const std::vector<FitParameter>& parameters_;
    std::vector<Ring> rings_;
};

Bounds searched(const FitParameter& parameter) {
    if (!parameter.is_logarithmic) return parameter.bounds;
    return {std::log(parameter.bounds.lowest), std::log(parameter.bounds.highest)};
}

/// Returns the point of a start: exponents that many landscapes have, wavelengths spread out.
std::vector<double> start_of(const std::vector<Bounds>& bounds, int start) {
    constexpr int kStarts = 5;
    std::vector<double> place;
    for (const Bounds& bound : bounds) {
        place.push_back(bound.lowest +
                        (bound.highest - bound.lowest) * (start + 1) / (kStarts + 1));
    }
    place[0] = 1.5;
    if (place.size() > 2) place[2] = 2.6;
    return place;
}

/// Returns the variance of the terrain's modes with S = e^level times the law's relative density.
double variance_of(const Terrain& terrain, const TerrainLaw& law, double level) {
    const int half = terrain.resolution / 2;
    const double dk = kTwoPi / terrain.patch_size;
    double sum = 0.0;
    for (int m = -half + 1; m < half; ++m) {
        for (int n = 0; n < half; ++n) {
            if (n == 0 && m <= 0) continue;
            sum += 2.0 * law.density(n * dk, m * dk);
        }
    }
    return std::exp(level) * sum * dk * dk;
}

}  // namespace

LawFit fit_law(std::span<const Ring> rings, FitLaw law, bool ridge, Terrain& terrain) {
    constexpr int kStarts = 5;
    constexpr double kAtBound = 1e-3;  // of the distance between the bounds
    const Bounds wavelengths{kTwoPi / rings.back().wavenumber, kTwoPi / rings.front().wavenumber};
    const std::vector<FitParameter> parameters = parameters_of(law, ridge, wavelengths);
    if (law == FitLaw::broken) terrain.breaks = {{wavelengths.lowest, 2.5}};
    std::vector<Bounds> bounds;
    std::vector<double> steps;
    for (const FitParameter& parameter : parameters) {
        bounds.push_back(searched(parameter));
        steps.push_back(0.15 * (bounds.back().highest - bounds.back().lowest));
    }
    RingResiduals residuals(rings, terrain, parameters);
    std::optional<Minimum> best;
    for (int start = 0; start < kStarts; ++start) {
        const Minimum found =
            minimize([&](std::span<const double> place) { return residuals.sum_of_squares(place); },
                     start_of(bounds, start), steps, bounds);
        if (!best || found.value < best->value) best = found;
    }
    residuals.set(terrain, best->place);
    LawFit fit;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        const double value =
            parameters[i].is_logarithmic ? std::exp(best->place[i]) : best->place[i];
        const double margin = kAtBound * (bounds[i].highest - bounds[i].lowest);
        const bool at_bound = best->place[i] < bounds[i].lowest + margin ||
                              best->place[i] > bounds[i].highest - margin;
        fit.parameters.push_back({parameters[i].name, value, at_bound});
    }
    const TerrainLaw fitted(terrain);
    fit.level = residuals.level(fitted);
    terrain.rms = std::sqrt(variance_of(terrain, fitted, fit.level));
    return fit;
}

}  // namespace ocean
