// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The waves of a sea with the crests of its file: modes are conditioned once, after they are drawn,
// so that every host reads them and knows no crests.
//
//     const ModeLattice lattice(parameters, ModeLattice::Memory::none, pool);
//     Modes modes = lattice.still_modes(pool);
//     make_waves(lattice, spectrum, parameters, pool, modes);
#pragma once

#include <vector>

#include "ocean/internal/directional_spectrum.hpp"
#include "ocean/parameters.hpp"
#include "ocean/sea_state.hpp"

namespace ocean {

class ModeLattice;
class ThreadPool;
struct CrestSource;
struct Modes;

/// Draws the waves of `modes`, which must belong to the lattice, and makes the sea's crests: each
/// has its height at its place and time, and no point of the waves near it is higher. Other places
/// keep their draw, less what the crests determine; a sea without crests keeps its bits. The bits
/// are the same for any number of threads. Returns the gains of ModeLattice::set_waves. Throws
/// Error invalid_value for a crest that these waves cannot make.
std::vector<double> make_waves(const ModeLattice& lattice, const DirectionalSpectrum& spectrum,
                               const Parameters& parameters, ThreadPool& pool, Modes& modes);

/// Returns the probability that one crest of a sea exceeds a height [m], by Rayleigh's distribution
/// of linear waves. significant_wave_height: [m].
double rayleigh_exceedance(double height, double significant_wave_height);
/// Returns the same probability by [Forristall 2000], of second order. mean_period: Tm01 [s].
double forristall_exceedance(double height, double significant_wave_height, double mean_period,
                             const Water& water);

/// Adds the sea's crests to a state of the same sea: how likely they are, what they do to the rest
/// of the patch, and warnings. modes: of the source.
void add_crests(const CrestSource& source, const Modes& modes, ThreadPool& pool, SeaState& state);

}  // namespace ocean
