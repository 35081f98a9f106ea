// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// How waves of the open sea are displaced over a bed. One shift for a band would give its groups
// half their speed; a map that is affine in the wave vector has a delay for groups, a delay across
// them, and a phase.
#pragma once

#include <vector>

#include "coast/bed/bed_grid.hpp"
#include "ocean/parameters.hpp"
#include "ocean/thread_pool.hpp"
#include "shore_bands.hpp"
#include "shore_progress.hpp"

namespace ocean {

/// The min depth that waves feel [m].
inline constexpr double kLeastFeltDepth = 0.6;

/// The maps of one ShoreWaves over the depth's grid, row-major. A wave of the open sea with the
/// wave vector k has at x the phase k . (x + D) + P.
struct DelayMaps {
    std::vector<float> shift_x, shift_y;          // D [m]
    std::vector<float> phase;                     // P [rad]
    std::vector<float> direction_x, direction_y;  // unit: where the waves travel
};

/// Returns the depth that waves feel [m]: the bed smoothed by a Gaussian of 6 m, at least 1.5
/// cells, then clamped to kLeastFeltDepth .. water_depth.
BedGrid felt_depth(const BedGrid& bed_height, double water_depth);

/// Returns the maps of each of bands.waves, in that order. depth: from felt_depth, > 0 and at most
/// the open sea's [m]. D and P are exactly 0 over water as deep as the open sea, or deeper than 5 /
/// k, if the waves come from such water only. The bits are the same for any pool. An exception of
/// `progress` ends the work.
std::vector<DelayMaps> shore_delays(const BedGrid& depth, const ShoreBands& bands,
                                    const Water& water, ThreadPool& pool,
                                    const ShoreProgress& progress = {});

}  // namespace ocean
