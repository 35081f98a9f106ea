// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Quantities of a coast's waves that depend on the depth alone, in tables over its logarithm, so
// that a place reads them without solving the dispersion relation.
#pragma once

#include <array>
#include <vector>

#include "coast/statics/shore_bands.hpp"
#include "coast/statics/shore_delays.hpp"
#include "field/jet.hpp"
#include "ocean/parameters.hpp"

namespace ocean {

/// The tables of one sea. Immutable; any thread may read them.
class ShoreDepths {
  public:
    /// Scalar: Jet, or Plain without derivatives.
    template <typename Scalar>
    struct Values {
        Scalar wavenumber;                             // of waves of the peak period [rad/m]
        std::array<Scalar, kShoreBands> displacement;  // coth(k d) of the bands' middles
    };

    ShoreDepths() = default;
    /// peak_omega: angular frequency of the spectrum's peak [rad/s], > 0.
    ShoreDepths(const ShoreBands& bands, double peak_omega, const Water& water);

    /// Returns the values at a depth [m] within kLeastFeltDepth .. water.depth.
    template <typename Scalar>
    Values<Scalar> at(const Scalar& depth) const;
    /// Returns coth(k d) of the bands' middles at depths that are equal ratios apart, at
    /// (log(depth) - first_log()) * per_log().
    const std::vector<Quad>& displacements() const { return displacement_; }
    float first_log() const { return first_; }
    float per_log() const { return per_log_; }
    /// Returns the wavenumbers of the bands' middles at a depth [rad/m].
    Quad band_wavenumbers(float depth) const;
    /// Returns coth(k d) of a band's middle in the open sea.
    float open_displacement(int band) const { return displacement_.back()[band]; }

  private:
    float first_ = 0.0f;  // logarithm of the first depth
    float per_log_ = 0.0f;
    /// An entry of the tables, and the weights of the entry and its neighbours.
    struct Place;
    Place place(float depth) const;

    std::vector<Quad> displacement_;
    std::vector<Quad> band_wavenumber_;  // logarithms
    std::vector<float> wavenumber_;      // logarithms
};

extern template ShoreDepths::Values<Jet> ShoreDepths::at(const Jet& depth) const;
extern template ShoreDepths::Values<Plain> ShoreDepths::at(const Plain& depth) const;

}  // namespace ocean
