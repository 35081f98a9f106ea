// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Wave systems as rows, density and spreading: parametric systems here, measured systems in
// measured_table.cpp.
#include "waves/spectrum/wave_system_table.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "ocean/internal/grid.hpp"
#include "ocean/internal/spreading.hpp"
#include "waves/spectrum/spreading_rows.hpp"

namespace ocean {

namespace {

/// Bounds of the error of linear interpolation between two rows.
struct Tolerance {
    double peak;  // relative to the largest density
    double tail;  // relative to the density itself, beyond the peak, where slopes come from
};
/// The error of a bent density is largest in the middle between two rows.
constexpr Tolerance kInTheMiddle = {5e-5, 1e-3};
/// Where the bend turns between two rows, the chord crosses the density, perhaps in the very
/// middle. The error t (1 - t) (a + b (1 - 2 t)) at a share t of the way is largest near 0.23 from
/// the end, or near 0.14 in a wide interval whose bend turns near its end. Between these shares the
/// error may be 1 % larger.
constexpr Tolerance kBesideTheMiddle = {0.99e-4, 1.1e-3};
constexpr double kSharesBeside[] = {0.23, 0.77, 0.14, 0.86};

struct Rows {
    std::vector<double> omega;
    std::vector<double> density;
};

/// Appends the rows in (low, high] that keep linear interpolation within the tolerances.
template <typename Density>
class RowRefinement {
  public:
    RowRefinement(const Density& density, double peak, Rows& rows)
        : density_(density), peak_(peak), largest_(density(peak)), rows_(rows) {}

    void refine(double low, double at_low, double high, double at_high, int depth) {
        const double middle = 0.5 * (low + high);
        const double value = density_(middle);
        const bool beyond = low >= peak_;
        if (depth == 0 || (holds(0.5 * (at_low + at_high), value, beyond, kInTheMiddle) &&
                           holds_beside_the_middle(low, at_low, high, at_high))) {
            rows_.omega.push_back(high);
            rows_.density.push_back(at_high);
            return;
        }
        refine(low, at_low, middle, value, depth - 1);
        refine(middle, value, high, at_high, depth - 1);
    }

  private:
    bool holds(double chord, double value, bool beyond_peak, const Tolerance& tolerance) const {
        const double tail = beyond_peak ? tolerance.tail * value + 1e-14 * largest_ : largest_;
        return std::abs(value - chord) <= std::min(tolerance.peak * largest_, tail);
    }

    bool holds_beside_the_middle(double low, double at_low, double high, double at_high) const {
        // The far tail bends in one direction, and hides no peak.
        if (std::max(at_low, at_high) < kBesideTheMiddle.peak * largest_) return true;
        const auto holds_at = [&](double share, const Tolerance& tolerance) {
            const double chord = at_low + share * (at_high - at_low);
            return holds(chord, density_(low + share * (high - low)), low >= peak_, tolerance);
        };
        if (holds_at(0.23, kInTheMiddle) && holds_at(0.77, kInTheMiddle)) return true;
        return std::ranges::all_of(kSharesBeside,
                                   [&](double share) { return holds_at(share, kBesideTheMiddle); });
    }

    const Density& density_;
    double peak_;
    double largest_;
    Rows& rows_;
};

template <typename Density>
Rows adaptive_rows(const Density& density, double low, double peak, double parameter_peak,
                   double high) {
    std::vector<double> knots = {low, peak, high};
    // Spreading functions change their formula at these multiples of the peak; Hasselmann's jumps.
    for (const double x : {0.95, 1.0, 1.6}) {
        knots.push_back(x * parameter_peak);
        knots.push_back(x * parameter_peak * (1.0 + 1e-9));
    }
    constexpr int kKnots = 48;
    for (int i = 1; i < kKnots; ++i) {
        knots.push_back(low * std::pow(high / low, static_cast<double>(i) / kKnots));
    }
    std::sort(knots.begin(), knots.end());
    Rows rows = {{low}, {density(low)}};
    RowRefinement refinement(density, peak, rows);
    for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
        const double at_low = rows.density.back();
        refinement.refine(knots[i], at_low, knots[i + 1], density(knots[i + 1]), 14);
    }
    return rows;
}

WaveSystemTable parametric_table(const WaveSystem& system, const Water& water, double highest) {
    const FrequencySpectrum spectrum = make_frequency_spectrum(system, water, highest);
    WaveSystemTable table;
    if (spectrum.flat()) return table;
    const Rescaling scale = make_rescaling(system, spectrum.peak, spectrum.m0);
    const auto density = [&](double omega) {
        return spectrum.density(omega / scale.stretch) * scale.energy / scale.stretch;
    };
    Rows rows =
        adaptive_rows(density, spectrum.lowest * scale.stretch, spectrum.peak * scale.stretch,
                      spectrum.parameter_peak * scale.stretch, spectrum.highest * scale.stretch);
    table.m0 = spectrum.m0 * scale.energy;
    table.rows = std::move(rows.omega);
    table.density = std::move(rows.density);

    const double wave_age_inverse = system.wind() * spectrum.parameter_peak / water.gravity;
    const double mean = system.direction_degrees() * kPi / 180.0;
    table.directions = directions_needed(system, wave_age_inverse);
    table.spreading = [spreading = SpreadingRows(system, wave_age_inverse, mean,
                                                 static_cast<std::size_t>(table.directions)),
                       rows = table.rows, peak = spectrum.parameter_peak * scale.stretch](
                          std::size_t row, std::span<double> distribution) {
        spreading.fill(rows[row] / peak, distribution);
    };
    return table;
}

}  // namespace

Rescaling make_rescaling(const WaveSystem& system, double peak, double m0) {
    Rescaling result;
    if (system.peak_period) result.stretch = kTwoPi / *system.peak_period / peak;
    if (system.significant_wave_height) {
        const double wanted = *system.significant_wave_height / 4.0;
        result.energy = wanted * wanted / m0;
    }
    return result;
}

WaveSystemTable make_wave_system_table(const WaveSystem& system, const Water& water,
                                       double highest) {
    WaveSystemTable table = system.spectrum == SpectrumKind::measured
                                ? make_measured_table(system, water)
                                : parametric_table(system, water, highest);
    const double share = system.energy_share;
    table.m0 *= share;
    for (double& density : table.density) density *= share;
    return table;
}

NaturalScale natural_scale(const WaveSystem& system, const Water& water, double highest) {
    if (system.spectrum == SpectrumKind::measured) return natural_measured_scale(system);
    const FrequencySpectrum spectrum = make_frequency_spectrum(system, water, highest);
    const double period =
        spectrum.flat() ? std::numeric_limits<double>::quiet_NaN() : kTwoPi / spectrum.peak;
    return {4.0 * std::sqrt(spectrum.m0), period, 0.0};
}

}  // namespace ocean
