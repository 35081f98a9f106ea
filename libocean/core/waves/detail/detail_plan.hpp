// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Each band of the detail as a lattice of modes, and its slopes by the spectrum. This is the stage
// between the sea's parameters and detail_maps.hpp.
#pragma once

#include <cstdint>
#include <vector>

#include "ocean/detail.hpp"
#include "waves/modes/mode_lattice.hpp"

namespace ocean {

/// A band and the lattice of its tile.
struct PlannedBand {
    DetailBand band;          // without its variance
    CascadeBand ring;         // in steps of the tile's lattice
    Parameters parameters;    // the sea's, with the grid of the tile's modes
    std::uint32_t noise = 0;  // number of the modes' noise
};

struct DetailPlan {
    double map_edge = 0.0;  // rad/m: the map holds the square |kx|, |ky| < map_edge
    std::vector<PlannedBand> bands;
    double rest = 0.0;  // m: shorter waves are in no band
};

DetailPlan plan_detail(const Parameters& parameters, const DetailSettings& settings);

/// Returns the integral of k^2 E over the wavelengths shortest < L <= longest [m] outside the
/// square |kx|, |ky| < map_edge [rad/m]; shortest 0 = no limit.
double slopes_outside(const DirectionalSpectrum& spectrum, const Water& water, double map_edge,
                      double shortest, double longest);

/// Returns the sum of k k^T over the variances of the modes of a lattice of one band; the same bits
/// for any number of threads.
SlopeVariance slopes_of_modes(const ModeLattice& lattice, const DirectionalSpectrum& spectrum,
                              const Grid& grid, ThreadPool& pool);

}  // namespace ocean
