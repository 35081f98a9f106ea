// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A measured sea on its way into the table: the record's own frequencies are the rows, its moments
// become distributions by the chosen estimate. Nothing is added that was not measured.
#include <algorithm>
#include <cmath>
#include <complex>

#include "ocean/grid.hpp"
#include "ocean/spreading.hpp"
#include "wave_system_table.hpp"

namespace ocean {

namespace {

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

/// The record in rad/s, after rescaling.
struct MeasuredDensity {
    std::vector<double> omega;
    std::vector<double> density;  // m^2 s/rad
    double m0 = 0.0;
    double peak = 0.0;     // as measured
    double stretch = 1.0;  // of all frequencies
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

/// Direction of the whole record, weighted by energy.
double mean_direction(const Moments& moments, const MeasuredDensity& sea) {
    std::complex<double> mean = 0.0;
    for (std::size_t i = 0; i < sea.omega.size(); ++i) {
        const double below = i > 0 ? sea.omega[i] - sea.omega[i - 1] : 0.0;
        const double above = i + 1 < sea.omega.size() ? sea.omega[i + 1] - sea.omega[i] : 0.0;
        mean += moments.first[i] * sea.density[i] * (below + above);
    }
    return std::arg(mean);
}

/// Distributions of the listed frequencies, mixed in between by energy: E is linear there, not D.
class MeasuredSpreading {
  public:
    MeasuredSpreading(Moments moments, MeasuredDensity sea, Estimator estimator)
        : moments_(std::move(moments)), sea_(std::move(sea)), estimator_(estimator) {}

    void operator()(double omega, std::span<double> row) {
        estimate_all(row.size());
        const std::vector<double>& listed = sea_.omega;
        const auto upper = std::upper_bound(listed.begin() + 1, listed.end() - 1, omega);
        const auto i = static_cast<std::size_t>(upper - listed.begin());
        const double weight =
            std::clamp((omega - listed[i - 1]) / (listed[i] - listed[i - 1]), 0.0, 1.0);
        const double left = (1.0 - weight) * sea_.density[i - 1];
        const double right = weight * sea_.density[i];
        const double share = left + right > 0.0 ? right / (left + right) : weight;
        for (std::size_t j = 0; j < row.size(); ++j) {
            row[j] = estimated_[i - 1][j] + share * (estimated_[i][j] - estimated_[i - 1][j]);
        }
    }

  private:
    void estimate_all(std::size_t directions) {
        if (!estimated_.empty() && estimated_.front().size() == directions) return;
        estimated_.assign(sea_.omega.size(), std::vector<double>(directions));
        for (std::size_t i = 0; i < estimated_.size(); ++i) {
            const std::complex<double> c1 = moments_.first[i];
            const std::complex<double> c2 = moments_.second[i];
            estimate_row(c1.real(), c1.imag(), c2.real(), c2.imag(), estimator_, estimated_[i]);
        }
    }

    Moments moments_;
    MeasuredDensity sea_;
    Estimator estimator_;
    std::vector<std::vector<double>> estimated_;
};

}  // namespace

WaveSystemTable make_measured_table(const WaveSystem& system, const Water& water) {
    const MeasuredDensity sea = rescaled_density(system);
    WaveSystemTable table;
    if (sea.m0 <= 0.0) return table;
    table.m0 = sea.m0;
    table.rows = sea.omega;
    table.density = [sea](double w) { return interpolate(sea.omega, sea.density, w); };

    Moments moments = fill_gaps(*system.measured);
    if (!moments.any) {
        // Calm air has no wave age; a metre per second stands for it.
        const double wave_age_inverse = std::max(system.wind_speed, 1.0) * sea.peak / water.gravity;
        const double mean = system.direction_degrees() * kPi / 180.0;
        table.directions = directions_needed(system, wave_age_inverse);
        table.spreading = [=, peak = sea.peak * sea.stretch](double w, std::span<double> row) {
            spreading_row(system, w / peak, wave_age_inverse, mean, row);
        };
        return table;
    }
    if (system.wind_direction) {  // replaces the record's own mean: everything is turned
        const double turn = *system.wind_direction * kPi / 180.0 - mean_direction(moments, sea);
        for (auto& c1 : moments.first) c1 *= std::polar(1.0, turn);
        for (auto& c2 : moments.second) c2 *= std::polar(1.0, 2.0 * turn);
    }
    table.directions = 1024;
    table.spreading = MeasuredSpreading(std::move(moments), sea, system.estimator);
    return table;
}

}  // namespace ocean
