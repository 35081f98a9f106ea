// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The spectrum of a terrain in rings; see terrain_rings.hpp. Amplitudes are read from the modes:
// a whole period needs neither a map nor a transform.
#include "ocean/internal/terrain_rings.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>

#include "ocean/internal/grid.hpp"
#include "ocean/internal/modes.hpp"
#include "ocean/internal/terrain_law.hpp"

namespace ocean {
namespace {

/// Returns the ring of each wave index, -1 outside the circle, for n = 0 .. N/2 - 1 of a row m.
void rings_of_row(int m, int size, std::vector<int>& rings) {
    const double limit = size / 2 - 1;
    for (std::size_t n = 0; n < rings.size(); ++n) {
        const double index = std::hypot(static_cast<double>(n), m);
        const bool inside = index >= 1.0 && index <= limit;
        rings[n] = inside ? static_cast<int>(kTerrainRingsPerOctave * std::log2(index) + 1e-9) : -1;
    }
}

/// Calls visit(n, m, ring) for the half plane of waves inside the circle.
template <typename Visit>
void each_wave(int size, const Visit& visit) {
    std::vector<int> rings(static_cast<std::size_t>(size / 2));
    for (int m = 1 - size / 2; m < size / 2; ++m) {
        rings_of_row(m, size, rings);
        for (int n = m > 0 ? 0 : 1; n < size / 2; ++n) {
            const int ring = rings[static_cast<std::size_t>(n)];
            if (ring >= 0) visit(n, m, static_cast<std::size_t>(ring));
        }
    }
}

/// Returns the densities of the modes in each ring [m^4].
std::vector<double> densities_of(const Modes& modes, const std::vector<TerrainRing>& rings) {
    const CascadeModes& tile = modes.cascades.front();
    const int size = modes.lattice.resolution;
    const double dk = modes.lattice.wavenumber_step();
    std::vector<double> sums(rings.size());
    each_wave(size, [&](int n, int m, std::size_t ring) {
        sums[ring] += 4.0 * std::norm(std::complex<double>(tile.h0[mode_index(n, m, size)]));
    });
    for (std::size_t i = 0; i < sums.size(); ++i) {
        if (rings[i].count > 0.0) sums[i] /= rings[i].count * dk * dk;
    }
    return sums;
}

/// Returns the rings with the law's densities, scaled to the rms that the terrain requests.
std::vector<TerrainRing> asked_rings(const TerrainModel& terrain, const TerrainState& state) {
    const int size = terrain.resolution;
    const double dk = kTwoPi / terrain.patch_size;
    const TerrainAmplitudes amplitude(TerrainLaw(terrain), dk, dk * size);
    std::vector<TerrainRing> rings(
        static_cast<std::size_t>(kTerrainRingsPerOctave * std::log2(size)));
    each_wave(size, [&](int n, int m, std::size_t ring) {
        const double a = amplitude(n * dk, m * dk);
        rings[ring].wavenumber += std::log(std::hypot(n, m) * dk);
        rings[ring].asked += a * a;
        rings[ring].count += 1.0;
    });
    double variance = 0.0;
    for (int m = 1 - size / 2; m < size / 2; ++m) {
        for (int n = m > 0 ? 0 : 1; n < size / 2; ++n) {
            const double a = amplitude(n * dk, m * dk);
            variance += 2.0 * a * a * dk * dk;
        }
    }
    const double scale = variance > 0.0 ? state.rms.asked * state.rms.asked / variance : 0.0;
    for (TerrainRing& ring : rings) {
        if (ring.count == 0.0) continue;
        ring.wavenumber = std::exp(ring.wavenumber / ring.count);
        ring.asked *= scale / ring.count;
    }
    return rings;
}

}  // namespace

std::vector<TerrainRing> terrain_rings(const Terrain& land, int seeds,
                                       const std::function<void(int done, int of)>& progress) {
    Terrain made(land, {});
    TerrainModel terrain = made.model();
    std::vector<TerrainRing> rings = asked_rings(terrain, made.state());
    std::vector<double> sums(rings.size()), squares(rings.size());
    for (int i = 0; i < seeds; ++i) {
        if (i > 0) {
            ++terrain.seed;
            made.set_model(terrain);
        }
        const std::vector<double> densities = densities_of(made.modes(), rings);
        for (std::size_t ring = 0; ring < rings.size(); ++ring) {
            if (i == 0) rings[ring].tile = densities[ring];
            rings[ring].mean += densities[ring] / seeds;
            const double log = densities[ring] > 0.0 ? std::log10(densities[ring]) : 0.0;
            sums[ring] += log / seeds;
            squares[ring] += log * log / seeds;
        }
        if (progress) progress(i + 1, seeds);
    }
    for (std::size_t ring = 0; ring < rings.size(); ++ring) {
        const double variance = squares[ring] - sums[ring] * sums[ring];
        rings[ring].scatter = std::sqrt(std::max(0.0, variance));
    }
    std::erase_if(rings, [](const TerrainRing& ring) { return ring.asked <= 0.0; });
    return rings;
}

}  // namespace ocean
