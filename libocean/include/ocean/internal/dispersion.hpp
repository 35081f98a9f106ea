// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Dispersion of linear waves for one body of water, in one object that every stage uses.
#pragma once

#include "ocean/parameters.hpp"

namespace ocean {

/// The properties of a wave of one wavenumber; see the functions of the same names.
struct DispersionPoint {
    double angular_frequency = 0.0;
    double group_velocity = 0.0;
    double horizontal_displacement = 0.0;
};

/// The dispersion relation omega^2 = (g k + s k^3) tanh(k d), s = Water::kinematic_tension. Deep
/// water and pure gravity waves are its limits, not other code. Wavenumbers k in [rad/m] and
/// angular frequencies omega in [rad/s], both > 0. Formulas and sources:
/// shaders/wave/dispersion.glsl. Immutable; any thread may use it.
class Dispersion {
  public:
    explicit Dispersion(const Water& water);
    /// Returns omega [rad/s].
    double angular_frequency(double k) const;
    /// Returns d omega / dk [m/s].
    double group_velocity(double k) const;
    /// Returns the k of omega, by Newton's method, converged to 1e-14 relative.
    double wavenumber(double omega) const;
    /// Returns coth(k d), the ratio of horizontal to vertical displacement at the surface.
    double horizontal_displacement(double k) const;
    /// Returns all three properties for the cost of one. They equal the single functions to
    /// rounding.
    DispersionPoint at(double k) const;

  private:
    double deep_wavenumber(double omega) const;

    double gravity_;
    double tension_;
    double depth_;
};

}  // namespace ocean
