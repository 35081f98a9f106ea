// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Second order of waves in deep water: the waves that a pair of waves binds, by theory and by the
// products that a map can afford, and the skewness that they give a sea.
#pragma once

#include "ocean/internal/directional_spectrum.hpp"
#include "ocean/parameters.hpp"
#include "ocean/sea_state.hpp"

namespace ocean {

/// The bound waves of two waves of amplitudes a1, a2 and phases psi1, psi2, as factors [1/m]:
///     a1 a2 (difference cos(psi1 - psi2) + sum cos(psi1 + psi2)).
struct BoundPair {
    double difference;
    double sum;
};

/// Returns the pair of theory in deep water, [Sharma and Dean 1981]; k1, k2 [rad/m], cosine of the
/// angle between the waves.
BoundPair bound_pair_of_theory(double k1, double k2, double cosine);
/// Returns the pair that BoundWaves makes.
BoundPair bound_pair_of_products(double k1, double k2, double cosine);

/// The part p of kernels along the bound wave; 1 - p acts in all directions alike.
inline constexpr double kBoundAlong = 0.8;

/// The samples of the lattice of products for each lattice step of the shortest binding wave, at
/// least.
inline constexpr double kSamplesPerBinding = 2.25;

/// Returns the wavenumber of the shortest waves that bind others [rad/m]: longer waves hold 99.5 %
/// of the energy, or less where half of the grid's samples does not hold their products. 0 for a
/// sea that is linear or flat. Needs validated parameters.
double binding_limit(const DirectionalSpectrum& spectrum, const Parameters& parameters);

/// Adds the skewness of a sea of second order to its state, and a warning if the waves are steeper
/// or the grid coarser than that describes. Does nothing to a linear sea.
void add_second_order(const DirectionalSpectrum& spectrum, const Parameters& parameters,
                      SeaState& state);

}  // namespace ocean
