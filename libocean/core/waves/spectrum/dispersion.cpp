// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The dispersion relation and its inverse; the formulas themselves are
// shaders/wave/dispersion.glsl.
#include "ocean/internal/dispersion.hpp"

#include <algorithm>
#include <cmath>

#include "wave/wave.hpp"

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

double Dispersion::horizontal_displacement(double k) const {
    return formula::horizontal_displacement(k, depth_);
}

DispersionPoint Dispersion::at(double k) const {
    // The formula of dispersion.glsl, with sech^2 = 1 - tanh^2. Beyond kd = 20 tanh is 1 to the
    // last bit.
    const double kd = std::min(k * depth_, 20.0);
    const double tangent = kd < 20.0 ? std::tanh(kd) : 1.0;
    const double tension = tension_ * k * k;
    DispersionPoint point;
    point.angular_frequency = std::sqrt((gravity_ * k + tension * k) * tangent);
    point.group_velocity = ((gravity_ + 3.0 * tension) * tangent +
                            kd * (gravity_ + tension) * (1.0 - tangent * tangent)) /
                           (2.0 * point.angular_frequency);
    point.horizontal_displacement = 1.0 / tangent;
    return point;
}

double Dispersion::deep_wavenumber(double omega) const {
    // Newton's method for g k + s k^3 = omega^2 falls towards the root from either limit above it.
    const double square = omega * omega;
    double k = square / gravity_;
    if (tension_ > 0.0) k = std::min(k, std::cbrt(square / tension_));
    for (int step = 0; step < 50; ++step) {
        const double rise = gravity_ + 3.0 * tension_ * k * k;
        const double change = (gravity_ * k + tension_ * k * k * k - square) / rise;
        k -= change;
        if (std::abs(change) < 1e-15 * k) break;
    }
    return k;
}

double Dispersion::wavenumber(double omega) const {
    const double deep = deep_wavenumber(omega);
    if (deep * depth_ >= 20.0) return deep;
    // In ln k the relation is nearly straight (slope 1/2 to 3/2), so Newton needs a few steps from
    // the deep-water guess; the shallow guess is used where it gives the longer wave.
    const double shallow = omega / std::sqrt(gravity_ * depth_);
    double log_k = std::log(std::max(deep, shallow));
    for (int step = 0; step < 50; ++step) {
        const double k = std::exp(log_k);
        const DispersionPoint wave = at(k);
        const double w = wave.angular_frequency;
        const double slope = k * wave.group_velocity / w;  // d ln omega / d ln k
        const double change = std::log(omega / w) / slope;
        log_k += change;
        if (std::abs(change) < 1e-14) break;
    }
    return std::exp(log_k);
}

}  // namespace ocean
