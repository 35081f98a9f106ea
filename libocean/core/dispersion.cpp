// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The dispersion relation and its inverse; the formulas themselves are
// shaders/wave/dispersion.glsl.
#include "ocean/dispersion.hpp"

#include <cmath>

#include "wave.hpp"

namespace ocean {

namespace formula = wave::double_precision;

Dispersion::Dispersion(const Water& water)
    : gravity_(water.gravity), tension_(water.kinematic_tension()), depth_(water.depth) {}

double Dispersion::angular_frequency(double k) const {
    return formula::angular_frequency(k, gravity_, tension_, depth_);
}

double Dispersion::group_velocity(double k) const {
    return formula::group_velocity(k, gravity_, tension_, depth_);
}

double Dispersion::horizontal_excursion(double k) const {
    return formula::horizontal_excursion(k, depth_);
}

double Dispersion::wavenumber(double omega) const {
    // In ln k the relation is nearly straight (slope 1/2 to 3/2), so Newton needs a few steps from
    // the deep-water guess; the shallow guess takes over where it gives the longer wave.
    const double deep = omega * omega / gravity_;
    const double shallow = omega / std::sqrt(gravity_ * depth_);
    double log_k = std::log(std::max(deep, shallow));
    for (int step = 0; step < 50; ++step) {
        const double k = std::exp(log_k);
        const double w = angular_frequency(k);
        const double slope = k * group_velocity(k) / w;  // d ln omega / d ln k
        const double change = std::log(omega / w) / slope;
        log_k += change;
        if (std::abs(change) < 1e-14) break;
    }
    return std::exp(log_k);
}

}  // namespace ocean
