// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The spectrum of a terrain in rings of wavenumbers, as its law requests it and as its tiles hold
// it, for plots and tables.
#pragma once

#include <functional>
#include <vector>

#include "ocean/terrain.hpp"

namespace ocean {

/// The waves of a ring.
struct TerrainRing {
    double wavenumber = 0.0;  // exp(mean log k) of the ring's waves [rad/m]
    double count = 0.0;       // waves of the lattice, each with its mirror
    double asked = 0.0;       // mean density of all seeds, by the law [m^4]
    double tile = 0.0;        // density of this very tile [m^4]
    double mean = 0.0;        // mean density of the seeds that were made [m^4]
    double scatter = 0.0;     // standard deviation of log10 of the density between these seeds
};

inline constexpr int kTerrainRingsPerOctave = 4;
inline constexpr int kMaxSpectrumSeeds = 256;

/// Returns the rings of the terrain that have energy, inside the circle of its Nyquist wavenumber,
/// from the longest waves on. Makes `seeds` (1 .. kMaxSpectrumSeeds) tiles, with the terrain's seed
/// and the seeds after it. `progress` is called after each; if it throws, the call ends.
std::vector<TerrainRing> terrain_rings(const Terrain& land, int seeds,
                                       const std::function<void(int done, int of)>& progress = {});

}  // namespace ocean
