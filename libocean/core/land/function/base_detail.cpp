// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Detail below the samples of a land; see base_detail.hpp.
#include "land/function/base_detail.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "ocean/internal/grid.hpp"
#include "ocean/internal/terrain_base.hpp"
#include "ocean/internal/terrain_law.hpp"

namespace ocean {
namespace {

constexpr double kFirstRing = 0.2, kLastRing = 0.5;  // of the Nyquist wavenumber, for the law
constexpr double kFirstDetail = 0.4;

/// Returns the response of the interpolating cubic spline to a wave of t radians a sample.
double spline_response(double t) {
    if (t == 0.0) return 1.0;
    const double sinc = std::sin(0.5 * t) / (0.5 * t);
    return sinc * sinc * sinc * sinc / ((2.0 + std::cos(t)) / 3.0);
}

/// Returns the wave below pi that a wave of t radians a sample is aliased to.
double alias(double t) {
    return std::abs(t - kTwoPi * std::round(t / kTwoPi));
}

/// Returns the mean of a function of the direction over a quarter of a turn.
template <typename Value>
double mean_of_directions(const Value& value) {
    constexpr int kDirections = 24;
    double sum = 0.0;
    for (int i = 0; i < kDirections; ++i) {
        const double theta = 0.25 * kTwoPi * (i + 0.5) / kDirections;
        sum += value(std::cos(theta), std::sin(theta));
    }
    return sum / kDirections;
}

}  // namespace

BaseDetail::BaseDetail(const TerrainBase& base, double shortest)
    : rings_(base.rings),
      cell_(std::sqrt(base.model.domain.step(0) * base.model.domain.step(1))),
      nyquist_(kPi / cell_),
      longest_(kTwoPi / (kFirstDetail * nyquist_)),
      shortest_(shortest),
      has_waves_(shortest > 0.0 && shortest < longest_) {
    double count = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
    const auto fit = [&](double low, double high) {
        count = x = y = xx = xy = 0.0;
        for (std::size_t i = 0; i < rings_.wavenumber.size(); ++i) {
            const double k = rings_.wavenumber[i];
            if (k < low * nyquist_ || k > high * nyquist_ || rings_.density[i] <= 0.0) continue;
            const double log_k = std::log(k), log_s = std::log(rings_.density[i]);
            count += 1.0;
            x += log_k;
            y += log_s;
            xx += log_k * log_k;
            xy += log_k * log_s;
        }
        return count >= 2.0;
    };
    if (!fit(kFirstRing, kLastRing) && !fit(0.0, 1.0)) {
        has_waves_ = false;  // the model is flat
        return;
    }
    slope_ = (count * xy - x * y) / (count * xx - x * x);
    // A density that does not fall would give short waves infinite energy.
    constexpr double kLeastFall = -2.2;
    slope_ = std::min(slope_, kLeastFall);
    log_density_ = (y - slope_ * x) / count;
}

double BaseDetail::measured(double k) const {
    const auto& at = rings_.wavenumber;
    const auto log_s = [&](std::size_t i) { return std::log(std::max(rings_.density[i], 1e-30)); };
    if (k <= at.front()) return rings_.density.front();
    if (k >= at.back()) {
        // The last rings are extrapolated to the Nyquist wavenumber.
        const std::size_t last = at.size() - 1, before = last > 3 ? last - 3 : 0;
        const double fall = (log_s(last) - log_s(before)) / std::log(at[last] / at[before]);
        return std::exp(log_s(last) + std::min(fall, 0.0) * std::log(k / at[last]));
    }
    const auto above = std::ranges::upper_bound(at, k);
    const auto i = static_cast<std::size_t>(above - at.begin());
    const double part = std::log(k / at[i - 1]) / std::log(at[i] / at[i - 1]);
    return std::exp(log_s(i - 1) + part * (log_s(i) - log_s(i - 1)));
}

double BaseDetail::law(double k) const {
    return std::exp(log_density_ + slope_ * std::log(k));
}

double BaseDetail::of_base(double k) const {
    return mean_of_directions([&](double cosine, double sine) {
        const double tx = k * cosine * cell_, ty = k * sine * cell_;
        const double response = spline_response(tx) * spline_response(ty);
        const double looks_like = std::hypot(alias(tx), alias(ty)) / cell_;
        return response * response * measured(std::max(looks_like, rings_.wavenumber.front()));
    });
}

RadialDensity BaseDetail::density() const {
    return tabulated([this](double k) { return std::max(0.0, law(k) - of_base(k)); },
                     kTwoPi / longest_, kTwoPi / shortest_);
}

double default_base_error(const TerrainBase& base) {
    const Domain& domain = base.model.domain;
    const auto columns = static_cast<std::size_t>(domain.samples[0]);
    const auto rows = static_cast<std::size_t>(domain.samples[1]);
    const float* const heights = base.model.heights.data();
    const auto difference = [](float a, float b) {
        return static_cast<double>(a) - static_cast<double>(b);
    };
    double sum = 0.0;
    for (std::size_t j = 0; j + 1 < rows; ++j) {
        for (std::size_t i = 0; i + 1 < columns; ++i) {
            const float* const at = heights + j * columns + i;
            const double x = difference(at[1], at[0]) / domain.step(0);
            const double y = difference(at[columns], at[0]) / domain.step(1);
            sum += x * x + y * y;
        }
    }
    const double slope = std::sqrt(sum / static_cast<double>((rows - 1) * (columns - 1)));
    return 0.1 * slope * std::max(domain.step(0), domain.step(1));
}

RadialDensity waves_below_lattice(const TerrainModel& terrain, double gain, double shortest) {
    const TerrainLaw law(terrain);
    const double nyquist = kPi / (terrain.patch_size / terrain.resolution);
    const auto density = [&](double k) {
        return gain * gain * mean_of_directions([&](double cosine, double sine) {
                   // The lattice has the waves within the square; the mean over both diagonals of
                   // the quarter serves laws with a direction.
                   if (k * std::max(cosine, sine) < nyquist) return 0.0;
                   return 0.5 *
                          (law.density(k * cosine, k * sine) + law.density(-k * sine, k * cosine));
               });
    };
    return tabulated(density, nyquist, kTwoPi / shortest);
}

}  // namespace ocean
