// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Estimates the spectrum of heights on a grid: the mean density over (kx, ky) in rings of equal
// ratio. Symbols: S density [m^4], variance = integral of S dkx dky [m^2]; k = |(kx, ky)| [rad/m].
//
// A grid that repeats is transformed as it is. A grid that exists once has no whole period of its
// waves: the jump from its right edge to its left one has a spectrum k^-2 that hides everything
// steeper. So the least-squares plane is removed and a Hann window is applied, whose loss of energy
// is corrected. Without the window crops of land with beta 2.0, 2.4 and 2.8 all read 1.5.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "ocean/domain.hpp"
#include "ocean/thread_pool.hpp"

namespace ocean {

enum class Taper {
    automatic,  // Hann for a domain that exists once, none for one that wraps
    hann,
    none,  // removes the mean only
};

struct RingOptions {
    int rings_per_octave = 4;
    Taper taper = Taper::automatic;
    /// Limit of the samples along a side of the squares that are transformed at once, a power of
    /// two. A larger grid is covered by such squares that overlap by at least half, and their
    /// densities are averaged [Welch 1967].
    int max_side = 4096;
    /// The lowest and the highest wavenumber of all rings [rad/m]; unset: ring_limits() of the
    /// grid.
    std::optional<std::array<double, 2>> limits = {};
};

/// Returns the limits that measure_rings chooses for a grid [rad/m]; see measure_rings.
std::array<double, 2> ring_limits(const Domain& domain, const RingOptions& options = {});

/// The mean of S over the waves of a ring.
struct Ring {
    double wavenumber;  // exp(mean log k) of the ring's waves [rad/m]
    double density;     // S [m^4]
    double count;       // independent waves of the grid in the ring, the weight of the ring
};

/// Returns the rings of equal ratio that have waves, narrowest first. On a grid that exists once
/// they reach from 2 waves along its shorter side to 0.8 of the smaller Nyquist wavenumber; on a
/// grid that wraps, from 1 wave to the Nyquist wavenumber. `heights` are a row-major array of
/// domain.count() heights [m]. Blocks until the pool is done. Throws Error invalid_value for less
/// than 16 samples along a side and for a height that is not finite, out_of_memory.
std::vector<Ring> measure_rings(const Domain& domain, std::span<const float> heights,
                                ThreadPool& pool, const RingOptions& options = {});

}  // namespace ocean
