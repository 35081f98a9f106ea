// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Dispersion of linear waves for one body of water: the one object that every stage asks.
#pragma once

#include "ocean/parameters.hpp"

namespace ocean {

/// What a wave of one wavenumber does: see the functions of the same names.
struct DispersionPoint {
    double angular_frequency = 0.0;
    double group_velocity = 0.0;
    double horizontal_displacement = 0.0;
};

/// omega^2 = (g k + s k^3) tanh(k d). Formulas and sources: shaders/wave/dispersion.glsl.
/// Wavenumbers in rad/m, frequencies in rad/s, both > 0.
class Dispersion {
  public:
    explicit Dispersion(const Water& water);
    double angular_frequency(double k) const;
    double group_velocity(double k) const;
    /// The k of a given omega: Newton's method, converged to 1e-14 relative.
    double wavenumber(double omega) const;
    /// coth(k d): sideways over upright displacement at the surface.
    double horizontal_displacement(double k) const;
    /// All three for the price of one, to rounding.
    DispersionPoint at(double k) const;

  private:
    double deep_wavenumber(double omega) const;

    double gravity_;
    double tension_;
    double depth_;
};

}  // namespace ocean
