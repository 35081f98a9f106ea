// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The modes of one band and sector (a pair), gathered from all cascades onto one lattice about a
// carrier: a wave in their midst. With the carrier divided out they vary slowly enough for a small
// map. This is the stage between the modes of the sea and the signals of band_signals.hpp.
#pragma once

#include <array>
#include <complex>
#include <span>
#include <vector>

#include "coast/statics/shore_bands.hpp"
#include "ocean/internal/modes.hpp"

namespace ocean {

/// Returns the index of the pair in `bands.waves` to which the mode (n, m) of the patch's own
/// lattice belongs, or -1. `step` is Lattice::wavenumber_step() of the patch's lattice.
int band_sector_of(const ShoreBands& bands, double step, int n, int m);

/// A wave of a pair: 2 h0 e^(i (k.x - omega t)).
struct BandMode {
    int n, m;                       // k minus the carrier, in steps of the pair's lattice
    std::complex<float> amplitude;  // 2 h0 [m]
    double rate;                    // turns per unit of tau, see CascadeModes
};

struct BandLattice {
    double period = 0.0;           // [m], a whole part of the patch's
    std::array<int, 2> carrier{};  // K, in steps of 2 pi / period
    std::array<int, 2> reach{};    // the highest |n| and |m| of the modes
    std::vector<BandMode> modes;   // ordered by m, then n
};

/// Returns a lattice for each pair of `bands`. Modes that have no amplitude are left out.
std::vector<BandLattice> gather_bands(const Modes& modes, const ShoreBands& bands);

/// Returns 1 / B^, the factor by which the coefficients of a cubic B-spline of `side` samples
/// exceed a wave of n periods along the side. B^(theta) = (sin(theta/2) / (theta/2))^4 [Unser
/// 1999].
double spline_gain(int n, int side);

/// Returns the samples along x and y of the map of each pair: the fewest powers of two, at least 6
/// times the pair's reach, with which the splines through all maps together err by `tolerance`
/// times the rms of all pairs together. No side is larger than kMaxResolution.
std::vector<std::array<int, 2>> choose_sides(std::span<const BandLattice> bands, double tolerance);

}  // namespace ocean
