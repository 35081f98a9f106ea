// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Slowness: see slowness.hpp.
#include "slowness.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "ocean/internal/dispersion.hpp"

namespace ocean {
namespace {

constexpr int kSlownessEntries = 1024;
// Without a threshold waves of 300 m would feel a bed of 250 m, and the open sea would change by
// 3e-5 of its height. A change of 1e-4 occurs at k d = 5.
constexpr double kNone = 1e-4;
constexpr double kWhole = 3e-4;  // larger changes count in full
constexpr double kDeep = 6.0;    // k d beyond which the change is less than kNone

/// Returns the change e of a slowness 1 + e with the part below the threshold removed, with two
/// continuous derivatives.
double threshold(double e) {
    const double t = std::clamp((e - kNone) / (kWhole - kNone), 0.0, 1.0);
    return e * (t * t * t * (t * (6.0 * t - 15.0) + 10.0));
}

}  // namespace

Slowness::Slowness(double k, const Water& water, double min_depth)
    : deepest_(std::min(water.depth, kDeep / k)) {
    const double omega = Dispersion(water).angular_frequency(k);
    first_ = std::sqrt(std::min(min_depth, deepest_));
    const double step = (std::sqrt(deepest_) - first_) / kSlownessEntries;
    scale_ = step > 0.0 ? 1.0 / step : 0.0;
    table_.reserve(kSlownessEntries + 1);
    for (int n = 0; n <= kSlownessEntries; ++n) {
        Water shallow = water;
        shallow.depth = n < kSlownessEntries ? (first_ + n * step) * (first_ + n * step) : deepest_;
        const double e = Dispersion(shallow).wavenumber(omega) / k - 1.0;
        table_.push_back(static_cast<float>(1.0 + threshold(e)));
    }
}

float Slowness::at(double depth) const {
    if (!(depth < deepest_)) return 1.0f;
    const double place = std::max((std::sqrt(depth) - first_) * scale_, 0.0);
    const auto n = static_cast<std::size_t>(std::min(place, kSlownessEntries - 1.0));
    const double t = place - static_cast<double>(n);
    return static_cast<float>((1.0 - t) * double{table_[n]} + t * double{table_[n + 1]});
}

}  // namespace ocean
