// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Fits a law to rings: see law_fit.hpp.
//
// The log of a ring's density scatters with a variance of 1 / count, and no simple law is closer to
// land than some per cent, so a ring weighs 1 / (1 / count + 0.1^2).
#include "law_fit.hpp"

#include <cmath>
#include <optional>
#include <utility>

#include "nelder_mead.hpp"
#include "ocean/internal/grid.hpp"
#include "ocean/internal/terrain_law.hpp"

namespace ocean {
namespace {

constexpr double kLawScatter = 0.1;  // of log S
constexpr Bounds kExponents{0.2, 4.5};
constexpr Bounds kRidgeGain{0.05, 50.0};
constexpr Bounds kRidgeWidth{0.15, 2.0};  // [octaves]
constexpr int kStarts = 5;
/// Chance alone would lower the sum of squares by more than this in one land of 100, if the waves
/// of a ring were independent (chi-squared of the two parameters of a break, or the five with a
/// ridge).
constexpr double kBreakOfChance = 9.21, kRidgeOfChance = 15.09;
/// The share of the waves that is independent under the Hann window: the square of (sum w^2)^2 / (n
/// sum w^4) = 18/35 [Welch 1967].
constexpr double kIndependent = 0.265;

/// A parameter of the fit: its name, bounds and setter.
struct FitParameter {
    const char* name;
    Bounds bounds;
    bool is_logarithmic;
    void (*set)(TerrainModel&, double);
    std::optional<double> start = {};  // unset: spread over the bounds
};

std::vector<FitParameter> parameters_of(FitLaw law, bool ridge, const Bounds& wavelengths) {
    std::vector<FitParameter> all = {
        {"beta", kExponents, false, [](TerrainModel& t, double value) { t.beta = value; }, 1.5}};
    if (law == FitLaw::broken) {
        all.push_back({"break_wavelength", wavelengths, true,
                       [](TerrainModel& t, double value) { t.breaks[0][0] = value; }});
        all.push_back({"break_beta", kExponents, false,
                       [](TerrainModel& t, double value) { t.breaks[0][1] = value; }, 2.6});
    }
    if (!ridge) return all;
    all.push_back({"ridge_wavelength", wavelengths, true,
                   [](TerrainModel& t, double value) { t.ridge_wavelength = value; }});
    all.push_back({"ridge_gain", kRidgeGain, true,
                   [](TerrainModel& t, double value) { t.ridge_gain = value; }});
    all.push_back({"ridge_width", kRidgeWidth, true,
                   [](TerrainModel& t, double value) { t.ridge_width = value; }});
    return all;
}

class RingResiduals {
  public:
    RingResiduals(std::span<const Ring> rings, const TerrainModel& terrain,
                  const std::vector<FitParameter>& parameters)
        : terrain_(terrain), parameters_(parameters) {
        for (const Ring& ring : rings) {
            if (ring.density > 0.0) rings_.push_back(ring);
        }
    }

    void set(TerrainModel& terrain, std::span<const double> place) const {
        for (std::size_t i = 0; i < parameters_.size(); ++i) {
            const double value = parameters_[i].is_logarithmic ? std::exp(place[i]) : place[i];
            parameters_[i].set(terrain, value);
        }
    }
    /// Returns the level at which a law fits best.
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

    TerrainModel terrain_;
    const std::vector<FitParameter>& parameters_;
    std::vector<Ring> rings_;
};

Bounds searched(const FitParameter& parameter) {
    if (!parameter.is_logarithmic) return parameter.bounds;
    return {std::log(parameter.bounds.lowest), std::log(parameter.bounds.highest)};
}

/// Returns the point of a start: exponents that many landscapes have, and wavelengths spread out.
std::vector<double> start_of(const std::vector<FitParameter>& parameters, int start) {
    std::vector<double> place;
    for (const FitParameter& parameter : parameters) {
        const Bounds bound = searched(parameter);
        place.push_back(parameter.start.value_or(bound.lowest + (bound.highest - bound.lowest) *
                                                                    (start + 1) / (kStarts + 1)));
    }
    return place;
}

/// A law whose parameters have their best values.
struct Candidate {
    std::vector<FittedParameter> parameters;
    TerrainModel terrain;
    double misfit = 0.0;  // sum of the weighted squares of the residuals
    double level = 0.0;
};

Candidate best_law(std::span<const Ring> rings, FitLaw law, bool ridge,
                   const TerrainModel& terrain) {
    constexpr double kAtBound = 1e-3;  // of the distance between the bounds
    const Bounds wavelengths{kTwoPi / rings.back().wavenumber, kTwoPi / rings.front().wavenumber};
    const std::vector<FitParameter> parameters = parameters_of(law, ridge, wavelengths);
    Candidate best{.parameters = {}, .terrain = terrain};
    best.terrain.breaks.clear();
    best.terrain.ridge_wavelength = 0.0;
    if (law == FitLaw::broken) best.terrain.breaks = {{wavelengths.lowest, 2.5}};
    std::vector<Bounds> bounds;
    std::vector<double> steps;
    for (const FitParameter& parameter : parameters) {
        bounds.push_back(searched(parameter));
        steps.push_back(0.15 * (bounds.back().highest - bounds.back().lowest));
    }
    RingResiduals residuals(rings, best.terrain, parameters);
    std::optional<Minimum> least;
    for (int start = 0; start < kStarts; ++start) {
        const Minimum found =
            minimize([&](std::span<const double> place) { return residuals.sum_of_squares(place); },
                     start_of(parameters, start), steps, bounds);
        if (!least || found.value < least->value) least = found;
    }
    residuals.set(best.terrain, least->place);
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        const double place = least->place[i];
        const double margin = kAtBound * (bounds[i].highest - bounds[i].lowest);
        const bool at_bound =
            place < bounds[i].lowest + margin || place > bounds[i].highest - margin;
        best.parameters.push_back(
            {parameters[i].name, parameters[i].is_logarithmic ? std::exp(place) : place, at_bound});
    }
    best.misfit = least->value;
    best.level = residuals.level(TerrainLaw(best.terrain));
    return best;
}

}  // namespace

LawFit fit_law(std::span<const Ring> rings, FitLaw law, bool ridge, TerrainModel& terrain) {
    Candidate best = best_law(rings, law, ridge, terrain);
    bool has_break = law == FitLaw::broken;
    if (has_break) {
        Candidate one = best_law(rings, FitLaw::one, false, terrain);
        const double chance = (ridge ? kRidgeOfChance : kBreakOfChance) / kIndependent;
        has_break = one.misfit - best.misfit > chance;
        if (!has_break) best = std::move(one);
    }
    terrain = std::move(best.terrain);
    return {.parameters = std::move(best.parameters), .level = best.level, .has_break = has_break};
}

}  // namespace ocean
