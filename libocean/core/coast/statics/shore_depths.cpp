// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "coast/statics/shore_depths.hpp"

#include <algorithm>
#include <cmath>

#include "field/quad_grid.hpp"
#include "ocean/internal/dispersion.hpp"

namespace ocean {
namespace {

// Cubics over steps of 6 % of the depth are exact to 1e-5.
constexpr int kEntries = 160;
/// In this depth every wave of a sea is in deep water [m].
constexpr double kDeepest = 6000.0;

}  // namespace

struct ShoreDepths::Place {
    std::array<std::size_t, 4> entry;
    CubicWeights weights;
};

ShoreDepths::Place ShoreDepths::place(float depth) const {
    const float at =
        std::clamp((std::log(depth) - first_) * per_log_, 0.0f, static_cast<float>(kEntries - 1));
    const int first = std::min(static_cast<int>(at), kEntries - 2);
    Place place{{}, CubicWeights(at - static_cast<float>(first))};
    for (int a = 0; a < 4; ++a) {
        place.entry[static_cast<std::size_t>(a)] =
            static_cast<std::size_t>(std::clamp(first + a - 1, 0, kEntries - 1));
    }
    return place;
}

ShoreDepths::ShoreDepths(const ShoreBands& bands, double peak_omega, const Water& water) {
    const double deepest = std::clamp(water.depth, 2.0 * kLeastFeltDepth, kDeepest);
    const double first = std::log(kLeastFeltDepth);
    const double step = (std::log(deepest) - first) / (kEntries - 1);
    first_ = static_cast<float>(first);
    per_log_ = static_cast<float>(1.0 / step);
    const Dispersion open(water);
    for (int i = 0; i < kEntries; ++i) {
        Water local = water;
        // The last entry is the open sea, however deep.
        local.depth = i + 1 < kEntries ? std::exp(first + i * step) : water.depth;
        const Dispersion dispersion(local);
        wavenumber_.push_back(static_cast<float>(std::log(dispersion.wavenumber(peak_omega))));
        Quad displacement{};
        Quad wavenumber{};
        for (int band = 0; band < kShoreBands; ++band) {
            const double omega = open.angular_frequency(bands.centre(band));
            const double k = dispersion.wavenumber(omega);
            displacement[band] = static_cast<float>(dispersion.horizontal_displacement(k));
            wavenumber[band] = static_cast<float>(std::log(k));
        }
        displacement_.push_back(displacement);
        band_wavenumber_.push_back(wavenumber);
    }
}

template <typename Scalar>
ShoreDepths::Values<Scalar> ShoreDepths::at(const Scalar& depth) const {
    const Place at = place(depth.value());
    float log_k = 0.0f;
    float log_k_slope = 0.0f;
    Quad displacement{};
    Quad displacement_slope{};
    for (std::size_t a = 0; a < 4; ++a) {
        const std::size_t i = at.entry[a];
        log_k += at.weights.value[a] * wavenumber_[i];
        log_k_slope += at.weights.slope[a] * wavenumber_[i];
        displacement += at.weights.value[a] * displacement_[i];
        displacement_slope += at.weights.slope[a] * displacement_[i];
    }
    const float by_depth = per_log_ / depth.value();
    const float k = std::exp(log_k);
    Values<Scalar> values;
    values.wavenumber = chain(depth, k, k * log_k_slope * by_depth);
    for (int band = 0; band < kShoreBands; ++band) {
        values.displacement[static_cast<std::size_t>(band)] =
            chain(depth, displacement[band], displacement_slope[band] * by_depth);
    }
    return values;
}

Quad ShoreDepths::band_wavenumbers(float depth) const {
    const Place at = place(depth);
    Quad wavenumber{};
    for (std::size_t a = 0; a < 4; ++a) {
        wavenumber += at.weights.value[a] * band_wavenumber_[at.entry[a]];
    }
    for (int band = 0; band < kShoreBands; ++band) wavenumber[band] = std::exp(wavenumber[band]);
    return wavenumber;
}

template ShoreDepths::Values<Jet> ShoreDepths::at(const Jet& depth) const;
template ShoreDepths::Values<Plain> ShoreDepths::at(const Plain& depth) const;

}  // namespace ocean
