// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Cascades: bands of wavenumbers with a lattice each, so that a large sea has short waves too. The
// lattice of cascade c has the period patch_size / m_c with whole numbers m_0 = 1 < m_1 < ...: each
// of its modes is a mode of the patch's own lattice, and the sea keeps the one period patch_size.
#pragma once

#include <limits>
#include <vector>

#include "ocean/parameters.hpp"

namespace ocean {

/// A ring of wavenumbers, half-open: inner <= |k| < outer in steps of the patch's lattice. A
/// cascade reaches from the end of the previous cascade to its own Nyquist line; the last one also
/// keeps the corners of its square, beyond that line.
struct CascadeBand {
    int divisor = 1;  // m_c
    double inner = 0.0;
    double outer = std::numeric_limits<double>::infinity();
    /// Side of the square |kx|, |ky| < inner_side that is cut out of the ring, because a map holds
    /// these waves already; 0 = none.
    double inner_side = 0.0;

    /// Returns true if the band has the mode (n, m) of its cascade's own lattice. Exact.
    bool contains(int n, int m) const;
    /// Returns true if the mode lies on the inner side of the band: its wave is too long.
    bool is_inside(int n, int m) const;
    bool operator==(const CascadeBand&) const = default;
};

/// Returns grid.cascade_divisors, or if that is empty, primes about 7 times apart, such as 1, 7,
/// 53: waves of two cascades then never repeat together. On small grids they lie closer, where a
/// band would otherwise begin with too few modes.
std::vector<int> cascade_divisors(const Grid& grid);
/// Returns one band for each cascade. Needs validated parameters.
std::vector<CascadeBand> cascade_bands(const Grid& grid);

/// Returns the shortest wavelength [m] that the modes hold in every direction, two samples of the
/// finest cascade. The corners of its square hold shorter waves, but none along an axis.
double shortest_wave(const Grid& grid);
/// Returns the shortest wavelength [m] that a map of `map_resolution` samples holds in every
/// direction.
double shortest_wave(const Grid& grid, int map_resolution);

/// Returns the smallest number of samples along a side, a power of two, whose map holds every mode.
/// It may exceed kMaxResolution.
long long complete_map_resolution(const Grid& grid);
/// Returns the samples along a side of a map for which a caller requests no resolution:
/// grid.resolution for one cascade; for several, four times that, at most 4096 and at most the
/// number that holds every mode.
int default_map_resolution(const Grid& grid);

}  // namespace ocean
