// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The waves that the wake of a hull may have: a lattice over the square around it, with what the
// hull's shape gives each wave.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "hulls/wake_task.hpp"
#include "ocean/internal/dispersion.hpp"
#include "ocean/internal/grid.hpp"
#include "ocean/internal/modes.hpp"
#include "ocean/page_vector.hpp"
#include "ocean/parameters.hpp"
#include "waves/kernel/packed_modes.hpp"

namespace ocean {

class ThreadPool;

/// The size of a wake: what the hull's keys say, or what is chosen in their place.
struct WakeSize {
    double side = 0.0;  // [m]
    int resolution = 0;
    double age = 0.0;  // [s]
    bool operator==(const WakeSize&) const = default;
};
/// Returns the size of a wake. Chosen: 16 lengths of the hull or 12 transverse waves of its highest
/// speed, at most 32 lengths; and 3.2 times the time in which it crosses that, 60 to 600 s.
WakeSize wake_size(const Hull& hull, double highest_speed, const Water& water);

/// Returns the volume of a hull [m^3].
double hull_volume(const Hull& hull);
/// Returns the mean of cosh k(z + d) / cosh kd over the draught, weighted by the breadth of the
/// hull's sections: 1 for long waves, 0 for short ones. In deep water the function is e^(kz).
double down_hull(const Hull& hull, double k, double depth);

/// Arrays of waves: whole blocks of neighbours along y, some of which have energy. First those with
/// m >= 0, the same m after one another; then, in the same order, the waves opposite to them.
class WakeLattice {
  public:
    WakeLattice(const Hull& hull, const WakeSize& size, const Water& water);

    const Lattice& lattice() const { return lattice_; }
    /// Returns the number of waves, a multiple of kWakeBlock.
    std::size_t count() const { return n_.size(); }
    /// Returns the waves of blocks first .. last - 1.
    WakeWaves waves(int first, int last) const;

    /// Returns modes without amplitudes.
    Modes still_modes() const;
    /// Sets the amplitudes of still_modes() from arrays of count() values.
    void set_amplitudes(const float* re, const float* im, Modes& modes) const;
    /// Sets those of packed still_modes() at time 0. factors: of each wave. places: where packed.
    void pack(const float* re, const float* im, const float* factors,
              const std::vector<std::size_t>& places, PackedModes& packed, ThreadPool& pool) const;
    /// Returns the places of the waves with m >= 0, each block in pieces of the kernel's lanes.
    std::vector<std::size_t> places(const PackedModes& packed) const;
    /// Returns the factors of the waves, count() of them.
    PageVector<float> factors(const ModeFactor& factor) const;
    /// Returns a bound of the displacement by amplitudes, as query_bounds() does.
    double farthest(const float* re, const float* im) const;

    static std::uint64_t bytes(int resolution);

  private:
    /// Adds a wave. gain: without the part down the hull [m].
    void add(const Dispersion& dispersion, int n, int m, double gain, const Hull& hull,
             const Water& water);

    /// Returns the index of a wave in the lattice.
    std::size_t index(std::size_t i) const;

    Lattice lattice_;
    PageVector<float> n_, m_, rate_high_, rate_low_, group_x_, group_y_, gain_;
    PageVector<float> moved_;  // square of the displacement over the height
    std::vector<WakeBlock> blocks_;
    std::vector<float> displacement_;  // coth(k d) / k of all modes [m]
};

}  // namespace ocean
