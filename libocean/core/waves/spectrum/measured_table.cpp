// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A measured sea on its way into the table: the record's own frequencies are the rows. Moments
// become distributions by the chosen estimate; a spectrum over directions is used unchanged. The
// table contains only what was measured.
#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <limits>
#include <memory>
#include <utility>

#include "ocean/internal/grid.hpp"
#include "ocean/internal/spreading.hpp"
#include "waves/spectrum/spreading_rows.hpp"
#include "waves/spectrum/wave_system_table.hpp"

namespace ocean {

namespace {

using Complex = std::complex<double>;

/// The moments of a buoy's record in every bin; neighbours in frequency fill its gaps.
struct Moments {
    std::vector<Complex> first;
    std::vector<Complex> second;
};

/// Fills gaps between bins with moments. Returns nothing if no bin has moments.
Moments fill_gaps(const SpectrumRecord& record) {
    Moments moments;
    const std::size_t n = record.frequency.size();
    if (!record.has_moments()) return moments;
    std::vector<std::size_t> known;
    for (std::size_t i = 0; i < n; ++i) {
        if (std::isfinite(record.a1[i] + record.b1[i])) known.push_back(i);
    }
    for (std::size_t i = 0; i < n && !known.empty(); ++i) {
        const auto after = std::lower_bound(known.begin(), known.end(), i);
        const std::size_t right = after == known.end() ? known.back() : *after;
        const std::size_t left = after == known.begin() || right == i ? right : *(after - 1);
        const double weight = left == right
                                  ? 0.0
                                  : (record.frequency[i] - record.frequency[left]) /
                                        (record.frequency[right] - record.frequency[left]);
        const auto mix = [&](const std::vector<double>& a, const std::vector<double>& b) {
            return (1.0 - weight) * Complex(a[left], b[left]) +
                   weight * Complex(a[right], b[right]);
        };
        moments.first.push_back(mix(record.a1, record.b1));
        moments.second.push_back(mix(record.a2, record.b2));
    }
    return moments;
}

/// Writes D(theta_j) of one listed frequency, whose sum is row.size() / 2 pi.
using ListedDistribution = std::function<void(std::size_t frequency, std::span<double> row)>;

ListedDistribution estimated_distribution(Moments moments, Estimator estimator, double turn) {
    for (Complex& c1 : moments.first) c1 *= std::polar(1.0, turn);
    for (Complex& c2 : moments.second) c2 *= std::polar(1.0, 2.0 * turn);
    return [moments = std::move(moments), estimator](std::size_t i, std::span<double> row) {
        const Complex c1 = moments.first[i];
        const Complex c2 = moments.second[i];
        estimate_row(c1.real(), c1.imag(), c2.real(), c2.imag(), estimator, row);
    };
}

/// Returns the record's own distribution, linear between its directions and periodic. It is
/// normalised on the columns of the table, so that each row keeps its energy for any columns.
ListedDistribution listed_distribution(std::shared_ptr<const SpectrumRecord> record, double turn) {
    return [record = std::move(record), turn](std::size_t frequency, std::span<double> row) {
        const std::vector<double>& listed = record->direction;
        const double* values = record->directional_density.data() + frequency * listed.size();
        const double step = 360.0 / static_cast<double>(row.size());
        double sum = 0.0;
        for (std::size_t j = 0; j < row.size(); ++j) {
            double at = static_cast<double>(j) * step - turn * 180.0 / kPi;
            at -= 360.0 * std::floor(at / 360.0);
            const auto upper = std::upper_bound(listed.begin(), listed.end(), at);
            const auto after = static_cast<std::size_t>(upper - listed.begin()) % listed.size();
            const std::size_t before = after == 0 ? listed.size() - 1 : after - 1;
            const auto ahead = [&](double d) { return d < 0.0 ? d + 360.0 : d; };
            const double gap = ahead(listed[after] - listed[before]);
            const double share = std::min(ahead(at - listed[before]) / gap, 1.0);
            row[j] = values[before] + share * (values[after] - values[before]);
            sum += row[j];
        }
        const auto columns = static_cast<double>(row.size());
        // A frequency without energy has no direction: any distribution will do.
        if (!(sum > 0.0)) std::fill(row.begin(), row.end(), 1.0 / kTwoPi);
        for (double& value : row) value *= sum > 0.0 ? columns / (kTwoPi * sum) : 1.0;
    };
}

/// Returns the first moment of each listed frequency.
std::vector<Complex> first_moments(const SpectrumRecord& record) {
    constexpr std::size_t kColumns = 1024;
    const ListedDistribution distribution =
        listed_distribution(std::make_shared<const SpectrumRecord>(record), 0.0);
    std::vector<double> row(kColumns);
    std::vector<Complex> first;
    for (std::size_t i = 0; i < record.frequency.size(); ++i) {
        distribution(i, row);
        Complex sum = 0.0;
        for (std::size_t j = 0; j < kColumns; ++j) {
            const double theta = kTwoPi * static_cast<double>(j) / kColumns;
            sum += row[j] * std::polar(1.0, theta);
        }
        first.push_back(sum * kTwoPi / static_cast<double>(kColumns));
    }
    return first;
}

/// The record in rad/s, after rescaling.
struct MeasuredDensity {
    std::vector<double> omega;
    std::vector<double> density;  // m^2 s/rad
    double m0 = 0.0;
    double peak = 0.0;     // measured peak
    double stretch = 1.0;  // factor of all frequencies
};

MeasuredDensity rescaled_density(const WaveSystem& system) {
    const SpectrumRecord& record = *system.measured;
    MeasuredDensity result;
    std::size_t top = 0;
    for (std::size_t i = 0; i < record.frequency.size(); ++i) {
        result.omega.push_back(kTwoPi * record.frequency[i]);
        result.density.push_back(record.density[i] / kTwoPi);
        if (record.density[i] > record.density[top]) top = i;
        if (i == 0) continue;
        result.m0 += 0.5 * (result.density[i] + result.density[i - 1]) *
                     (result.omega[i] - result.omega[i - 1]);
    }
    result.peak = result.omega[top];
    if (result.m0 <= 0.0) return result;
    const Rescaling scale = make_rescaling(system, result.peak, result.m0);
    result.stretch = scale.stretch;
    result.m0 *= scale.energy;
    for (double& w : result.omega) w *= scale.stretch;
    for (double& s : result.density) s *= scale.energy / scale.stretch;
    return result;
}

/// Returns the direction of the whole record, weighted by energy.
double mean_direction(const std::vector<Complex>& first_moments, const MeasuredDensity& sea) {
    Complex mean = 0.0;
    for (std::size_t i = 0; i < sea.omega.size(); ++i) {
        const double below = i > 0 ? sea.omega[i] - sea.omega[i - 1] : 0.0;
        const double above = i + 1 < sea.omega.size() ? sea.omega[i + 1] - sea.omega[i] : 0.0;
        mean += first_moments[i] * sea.density[i] * (below + above);
    }
    return std::arg(mean);
}

/// Returns the first moments of a record, whatever the form of its directions; empty if it has
/// none.
std::vector<Complex> directions_of(const SpectrumRecord& record) {
    if (record.is_directional()) return first_moments(record);
    return fill_gaps(record).first;
}

}  // namespace

NaturalScale natural_measured_scale(const WaveSystem& system) {
    WaveSystem as_measured = system;
    as_measured.significant_wave_height.reset();
    as_measured.peak_period.reset();
    const MeasuredDensity sea = rescaled_density(as_measured);
    if (sea.m0 <= 0.0) return {0.0, std::numeric_limits<double>::quiet_NaN(), 0.0};
    const std::vector<Complex> first = directions_of(*system.measured);
    const double direction = first.empty() ? 0.0 : mean_direction(first, sea) * 180.0 / kPi;
    return {4.0 * std::sqrt(sea.m0), kTwoPi / sea.peak, direction};
}

WaveSystemTable make_measured_table(const WaveSystem& system, const Water& water) {
    const MeasuredDensity sea = rescaled_density(system);
    WaveSystemTable table;
    if (sea.m0 <= 0.0) return table;
    table.m0 = sea.m0;
    table.rows = sea.omega;
    table.density = sea.density;

    Moments moments = fill_gaps(*system.measured);
    if (moments.first.empty() && !system.measured->is_directional()) {
        // Calm air has no wave age: the min wind here is 1 m/s.
        const double wave_age_inverse = std::max(system.wind(), 1.0) * sea.peak / water.gravity;
        const double mean = system.direction_degrees() * kPi / 180.0;
        table.directions = directions_needed(system, wave_age_inverse);
        table.spreading = [spreading = SpreadingRows(system, wave_age_inverse, mean,
                                                     static_cast<std::size_t>(table.directions)),
                           sea](std::size_t row, std::span<double> distribution) {
            spreading.fill(sea.omega[row] / (sea.peak * sea.stretch), distribution);
        };
        return table;
    }
    double turn = 0.0;
    if (system.wind_direction) {  // replaces the record's mean direction by turning all
        turn = *system.wind_direction * kPi / 180.0 -
               mean_direction(directions_of(*system.measured), sea);
    }
    table.directions = 1024;
    table.spreading = moments.first.empty()
                          ? listed_distribution(system.measured, turn)
                          : estimated_distribution(std::move(moments), system.estimator, turn);
    return table;
}

}  // namespace ocean
