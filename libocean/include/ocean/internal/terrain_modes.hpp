// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The modes of a terrain: complex noise keyed by the integer wave index, times the root of the
// density. A terrain is Modes whose rates and displacements are 0, so the maps, backends and
// queries of the sea serve it.
#pragma once

#include <array>
#include <complex>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "ocean/internal/modes.hpp"
#include "ocean/internal/terrain_law.hpp"
#include "ocean/page_vector.hpp"
#include "ocean/terrain_model.hpp"

namespace ocean {

class ThreadPool;

/// White noise by wave index: g(n, m) for n = 0 .. N/2 - 1 and m = -N/2 + 1 .. N/2 - 1, real and
/// imaginary part of variance 1 each. The other half plane is its mirror, g(-n, -m) = conj g(n, m).
/// g depends on seed, n and m alone: a finer grid keeps the bits of shared waves. A layer of period
/// patch_size / d adds d gain g_layer(n / d, m / d) where d divides n and m.
class TerrainNoise {
  public:
    TerrainNoise(const TerrainModel& terrain, ThreadPool& pool);

    int resolution() const { return resolution_; }
    /// Returns g(0 .. N/2 - 1, m) for a signed m; 0 at the mean, the mirrored half of n = 0 and the
    /// Nyquist row.
    std::span<const std::complex<float>> row(int m) const;
    std::uint64_t bytes() const { return values_.size() * sizeof(std::complex<float>); }

    /// Returns sum S |g|^2 over the half plane, in double. Costs some thousand operations for a law
    /// that has neither directions nor limits of wavelength on this lattice, else a sum over all
    /// waves. The bits are the same for any number of threads.
    double energy(const TerrainAmplitudes& amplitude, ThreadPool& pool) const;

  private:
    /// Sums over the waves of a cell of k^2: |g|^2 times 1, part and part^2, where part is the
    /// position in the cell. There S is the square of a straight line, so that the sums give its
    /// energy.
    struct CellMoments {
        std::array<double, 3> sums{};
    };
    void add_moments();

    int resolution_;
    double wavenumber_step_;
    PageVector<std::complex<float>> values_;  // [FFT index of m][n]
    std::int64_t first_cell_ = 0;
    std::vector<CellMoments> moments_;
};

/// Returns the lattice of a terrain: its resolution and patch_size.
Lattice lattice_of(const TerrainModel& terrain);
/// Returns still modes of amplitude 0 on the lattice of the terrain.
Modes empty_terrain_modes(const TerrainModel& terrain);

/// The scale of a terrain's modes.
struct TerrainScale {
    /// Factor of sqrt(S) to metres: 1 for a measured spectrum that keeps its own rms.
    double gain = 1.0;
    /// rms of this very tile [m], summed in double before the amplitudes are stored (Parseval).
    double rms = 0.0;
};

/// Writes h0 = h / 2 of each mode, with h(k) = gain sqrt(S / 2) dk g and h(-k) = conj h(k), dk = 2
/// pi / patch_size, so that the height is the sum of h(k) exp(i k x). Scales the heights to `rms`
/// [m], or leaves the law's amplitudes if `rms` is not given. For a land with gullies only a part
/// of the waves may be written, with the scale of the whole. `modes` come from empty_terrain_modes.
/// The bits are the same for any number of threads.
TerrainScale set_terrain_modes(const TerrainModel& terrain, const TerrainNoise& noise,
                               std::optional<double> rms, ThreadPool& pool, Modes& modes,
                               LawPart part = LawPart::whole);

}  // namespace ocean
