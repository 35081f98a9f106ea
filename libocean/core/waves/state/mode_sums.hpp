// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The part of a spectrum that a grid resolves: sums over the variances of its modes, without a
// random draw.
#pragma once

#include <array>
#include <complex>
#include <cstddef>
#include <vector>

#include "ocean/internal/cascades.hpp"
#include "ocean/internal/directional_spectrum.hpp"
#include "ocean/parameters.hpp"
#include "ocean/thread_pool.hpp"
#include "waves/modes/mode_lattice.hpp"
#include "waves/modes/quadrant_sampler.hpp"

namespace ocean {

/// [p]: mean square slope of the modes that a map of 2^p samples holds but a map of half as many
/// does not.
using SlopeByMap = std::array<double, 32>;

/// Sums over one row of modes, over a cascade, or over the whole sea.
struct ModeSums {
    double m0 = 0.0;
    double measured = 0.0;  // part of m0 in the modes of measures_band
    double m1 = 0.0;        // sum of omega times the variance
    double m_minus1 = 0.0;  // sum of the variance over omega
    double mean_square_slope = 0.0;
    SlopeByMap slope_by_map{};
    std::complex<double> direction = 0.0;
    double loop_error = 0.0;  // variance times the square of the speed's error
    double shortest = 0.0;    // m; 0 = no mode has energy
    double longest = 0.0;
    std::vector<double> ring;        // variance by whole |k| / dk of the cascade's lattice
    std::vector<double> ring_omega;  // variance times omega

    void add(const ModeSums& other);
};

/// The input of the sums over a sea's modes.
struct StateSource {
    const Parameters& parameters;
    const ModeLattice& lattice;
    const QuadrantSampler& spectrum;
};

/// Returns the sums of one cascade, its gain included; the bits are the same for any number of
/// threads.
ModeSums sum_modes(const StateSource& source, const DirectionalSpectrum& spectrum,
                   std::size_t cascade, const CascadeBand& band, ThreadPool& pool);

/// Returns (speed in the loop - speed) / speed for waves of that frequency; 0 without a loop.
double speed_error(double omega, double loop_period);

}  // namespace ocean
