// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Parametric and measured wave systems, each as rows, density and spreading. The only place that
// asks which kind of spectrum a system has after spectrum.cpp and spreading.cpp.
#include "wave_system_table.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

#include "ocean/grid.hpp"
#include "ocean/spreading.hpp"

namespace ocean {

namespace {

// Bounds of linear interpolation between two rows: of the peak, and, beyond the peak where the
// slopes of the sea come from, of the value itself.
constexpr double kPeakTolerance = 5e-5;
constexpr double kTailTolerance = 1e-3;

/// Appends the rows in (low, high] that keep linear interpolation within the tolerances.
class RowRefinement {
  public:
    RowRefinement(const std::function<double(double)>& density, double peak)
        : density_(density), peak_(peak), largest_(density(peak)) {}

    void refine(double low, double at_low, double high, double at_high, int depth,
                std::vector<double>& rows) const {
        const double middle = 0.5 * (low + high);
        const double value = density_(middle);
        const double error = std::abs(value - 0.5 * (at_low + at_high));
        const double tail = low < peak_ ? largest_ : kTailTolerance * value + 1e-14 * largest_;
        if (depth == 0 || error <= std::min(kPeakTolerance * largest_, tail)) {
            rows.push_back(high);
            return;
        }
        refine(low, at_low, middle, value, depth - 1, rows);
        refine(middle, value, high, at_high, depth - 1, rows);
    }

  private:
    const std::function<double(double)>& density_;
    double peak_;
    double largest_;
};

std::vector<double> adaptive_rows(const std::function<double(double)>& density, double low,
                                  double peak, double parameter_peak, double high) {
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
    const RowRefinement refinement(density, peak);
    std::vector<double> rows = {low};
    for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
        refinement.refine(knots[i], density(knots[i]), knots[i + 1], density(knots[i + 1]), 14,
                          rows);
    }
    return rows;
}

/// Rescaling of [[waves]]: the period stretches the spectrum at constant energy,
/// S'(omega) = S(omega / r) / r with r = new peak / old peak; the height scales it.
struct Rescaling {
    double stretch = 1.0;
    double energy = 1.0;
};

Rescaling make_rescaling(const WaveSystem& system, double peak, double m0) {
    Rescaling result;
    if (system.peak_period) result.stretch = kTwoPi / *system.peak_period / peak;
    if (system.significant_wave_height) {
        const double wanted = *system.significant_wave_height / 4.0;
        result.energy = wanted * wanted / m0;
    }
    return result;
}

WaveSystemTable parametric_table(const WaveSystem& system, const Water& water, double highest) {
    const FrequencySpectrum spectrum = make_frequency_spectrum(system, water, highest);
    WaveSystemTable table;
    if (spectrum.flat()) return table;
    const Rescaling scale = make_rescaling(system, spectrum.peak, spectrum.m0);
    const double low = spectrum.lowest * scale.stretch;
    const double high = spectrum.highest * scale.stretch;
    table.m0 = spectrum.m0 * scale.energy;
    table.density = [density = spectrum.density, scale, low, high](double omega) {
        if (omega < low || omega > high) return 0.0;
        return density(omega / scale.stretch) * scale.energy / scale.stretch;
    };
    table.rows = adaptive_rows(table.density, low, spectrum.peak * scale.stretch,
                               spectrum.parameter_peak * scale.stretch, high);

    const double wave_age_inverse = system.wind_speed * spectrum.parameter_peak / water.gravity;
    const double mean = system.direction_degrees() * kPi / 180.0;
    table.directions = directions_needed(system, wave_age_inverse);
    table.spreading = [system, mean, wave_age_inverse,
                       peak = spectrum.parameter_peak * scale.stretch](double omega,
                                                                       std::span<double> row) {
        spreading_row(system, omega / peak, wave_age_inverse, mean, row);
    };
    return table;
}

/// The moments of a record in every bin: gaps filled from the neighbours in frequency.
struct Moments {
    std::vector<std::complex<double>> first;
    std::vector<std::complex<double>> second;
    bool any = false;
};

Moments fill_gaps(const SpectrumRecord& record) {
    Moments moments;
    const std::size_t n = record.frequency.size();
    if (!record.has_directions()) return moments;
    std::vector<std::size_t> known;
    for (std::size_t i = 0; i < n; ++i) {
        const double sum = record.a1[i] + record.b1[i] + record.a2[i] + record.b2[i];
        if (std::isfinite(sum)) known.push_back(i);
    }
    moments.any = !known.empty();
    for (std::size_t i = 0; i < n && moments.any; ++i) {
        const auto after = std::lower_bound(known.begin(), known.end(), i);
        const std::size_t right = after == known.end() ? known.back() : *after;
        const std::size_t left = after == known.begin() || right == i ? right : *(after - 1);
        const double weight = left == right
                                  ? 0.0
                                  : (record.frequency[i] - record.frequency[left]) /
                                        (record.frequency[right] - record.frequency[left]);
        const auto mix = [&](const std::vector<double>& a, const std::vector<double>& b) {
            return (1.0 - weight) * std::complex<double>(a[left], b[left]) +
                   weight * std::complex<double>(a[right], b[right]);
        };
        moments.first.push_back(mix(record.a1, record.b1));
        moments.second.push_back(mix(record.a2, record.b2));
    }
    return moments;
}

/// Linear interpolation between the listed frequencies, nothing beyond them.
double interpolate(const std::vector<double>& x, const std::vector<double>& y, double at) {
    if (at < x.front() || at > x.back()) return 0.0;
    const auto upper = std::upper_bound(x.begin() + 1, x.end() - 1, at);
    const auto i = static_cast<std::size_t>(upper - x.begin());
    const double weight = (at - x[i - 1]) / (x[i] - x[i - 1]);
    return (1.0 - weight) * y[i - 1] + weight * y[i];
}

WaveSystemTable measured_table(const WaveSystem& system, const Water& water) {
    const SpectrumRecord& record = *system.measured;
    WaveSystemTable table;
    std::vector<double> omega;
    std::vector<double> density;
    for (std::size_t i = 0; i < record.frequency.size(); ++i) {
        omega.push_back(kTwoPi * record.frequency[i]);
        density.push_back(record.density[i] / kTwoPi);
    }
    std::size_t top = 0;
    for (std::size_t i = 0; i < omega.size(); ++i) {
        if (density[i] > density[top]) top = i;
        if (i > 0) table.m0 += 0.5 * (density[i] + density[i - 1]) * (omega[i] - omega[i - 1]);
    }
    if (table.m0 <= 0.0) return WaveSystemTable{};
    const double peak = omega[top];
    const Rescaling scale = make_rescaling(system, peak, table.m0);
    table.m0 *= scale.energy;
    for (double& w : omega) w *= scale.stretch;
    for (double& s : density) s *= scale.energy / scale.stretch;
    table.rows = omega;
    table.density = [omega, density](double w) { return interpolate(omega, density, w); };
    table.directions = 1024;

    const Moments moments = fill_gaps(record);
    std::complex<double> mean = 0.0;
    for (std::size_t i = 0; i < moments.first.size(); ++i) {
        const double below = i > 0 ? omega[i] - omega[i - 1] : 0.0;
        const double above = i + 1 < omega.size() ? omega[i + 1] - omega[i] : 0.0;
        mean += moments.first[i] * density[i] * (below + above);
    }
    if (!moments.any) {
        const double wave_age_inverse = std::max(system.wind_speed, 1.0) * peak / water.gravity;
        table.directions = directions_needed(system, wave_age_inverse);
        table.spreading = [=, peak = peak * scale.stretch](double w, std::span<double> row) {
            spreading_row(system, w / peak, wave_age_inverse,
                          system.direction_degrees() * kPi / 180.0, row);
        };
        return table;
    }
    // A given wind_direction replaces the record's own mean: everything is turned by the
    // difference.
    const double turn =
        system.wind_direction ? *system.wind_direction * kPi / 180.0 - std::arg(mean) : 0.0;
    // Between two listed frequencies the density E is linear in omega, not D: mix by energy.
    table.spreading = [=, estimator = system.estimator](double w, std::span<double> row) {
        const auto estimate = [&](std::size_t i, std::span<double> into) {
            const std::complex<double> c1 = moments.first[i] * std::polar(1.0, turn);
            const std::complex<double> c2 = moments.second[i] * std::polar(1.0, 2.0 * turn);
            estimate_row(c1.real(), c1.imag(), c2.real(), c2.imag(), estimator, into);
        };
        const auto upper = std::upper_bound(omega.begin() + 1, omega.end() - 1, w);
        const auto i = static_cast<std::size_t>(upper - omega.begin());
        const double weight = std::clamp((w - omega[i - 1]) / (omega[i] - omega[i - 1]), 0.0, 1.0);
        const double left = (1.0 - weight) * density[i - 1];
        const double right = weight * density[i];
        const double share = left + right > 0.0 ? right / (left + right) : weight;
        std::vector<double> other(row.size());
        estimate(i - 1, row);
        estimate(i, other);
        for (std::size_t j = 0; j < row.size(); ++j) row[j] += share * (other[j] - row[j]);
    };
    return table;
}

}  // namespace

WaveSystemTable make_wave_system_table(const WaveSystem& system, const Water& water,
                                       double highest) {
    return system.spectrum == SpectrumKind::measured ? measured_table(system, water)
                                                     : parametric_table(system, water, highest);
}

}  // namespace ocean
