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
/// cascade reaches from where the one before it ends to its own Nyquist line; the last one also
/// keeps the corners of its square, beyond that line.
struct CascadeBand {
    int divisor = 1;  // m_c
    double inner = 0.0;
    double outer = std::numeric_limits<double>::infinity();
    /// Of the ring only what lies outside the square |kx|, |ky| < inner_side: what a map lacks.
    double inner_side = 0.0;

    /// Mode (n, m) of the cascade's own lattice, exact.
    bool contains(int n, int m) const;
    /// Whether the mode lies on the band's inner side.
    bool is_inside(int n, int m) const;
    bool operator==(const CascadeBand&) const = default;
};

/// grid.cascade_divisors, or when that is empty primes 7 times apart, such as 1, 7, 53: waves of
/// two cascades then never repeat together. Closer on small grids, where a band would otherwise
/// begin with too few modes.
std::vector<int> cascade_divisors(const Grid& grid);
/// One band for each cascade. Needs validated parameters.
std::vector<CascadeBand> cascade_bands(const Grid& grid);

/// The shortest wave of the modes that runs in any direction, two samples of the finest cascade;
/// in the corners of its square there are shorter ones, along no axis.
double shortest_wave(const Grid& grid);
/// That of a map of so many samples.
double shortest_wave(const Grid& grid, int map_resolution);

/// Smallest number of samples, a power of two, whose map holds every mode; may be more than
/// kMaxResolution.
long long complete_map_resolution(const Grid& grid);
/// What a map has when nobody says: grid.resolution, or for several cascades four times that, at
/// most 4096 and at most what holds every mode.
int default_map_resolution(const Grid& grid);

}  // namespace ocean
