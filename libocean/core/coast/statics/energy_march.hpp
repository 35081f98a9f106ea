// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The energy of the waves over a bed: shadow behind land, refraction, shoaling and loss by
// breaking. Directions march from one row of cells to the next, away from the open sea; nothing
// travels back. Reflection, diffraction and currents are left out.
#pragma once

#include <cstdint>
#include <vector>

#include "coast/bed/bed_grid.hpp"
#include "coast/bed/still_water.hpp"
#include "ocean/domain.hpp"
#include "ocean/internal/directional_spectrum.hpp"
#include "ocean/parameters.hpp"
#include "shore_bands.hpp"
#include "shore_progress.hpp"

namespace ocean {

class ThreadPool;

struct MarchSettings {
    /// The side of a cell of the march and of the maps [m], 4 .. 64. Land of any width stops waves;
    /// water narrower than a cell may be missed.
    double cell = 16.0;
    /// The width of a bin of directions [rad], 1 .. 15 degrees.
    double direction_bin = kTwoPi / 72.0;  // 5 degrees
    /// The min depth that waves feel [m].
    double min_depth = 0.6;
};

/// Maps over coarse cells that cover the bed's domain, row-major [j][i]. Depths are the unsmoothed
/// bed's, at least min_depth and at most the open sea's. Land swallows waves; the maps continue
/// into the first cell of land, as if it were min_depth below the water, and are 0 beyond. Water
/// behind land has the energy of the cells that no land separates from it.
struct EnergyMaps {
    Domain domain{.wraps = false};
    /// Amplitudes relative to the open sea, one map for each of bands.waves: 1 where the bed is
    /// nowhere shallower than the open sea.
    std::vector<std::vector<float>> amplitude;
    std::vector<float> rms_height;      // Hrms of all waves together [m]
    std::vector<float> breaking_share;  // of the waves, 0 .. 1
    std::vector<float>
        arrival;  // share of the open sea's energy that arrives if none breaks, 0 .. 2
    std::vector<float> group_width;  // sqrt(sum over waves of (share of the energy)^2), 0 .. 1
    /// For each sample, the index of the sample whose values it has; on land this is another sample
    /// once the maps are continued there. Empty: each has its own.
    std::vector<std::uint32_t> source;
    /// The samples of the bed that no wave reaches; amplitudes and arrival are 0 there.
    StillWater still;
};

/// Returns the maps of one sea over one bed [m, up]. Each system of waves marches along its mean
/// direction: sectors are joined into as few marches as possible, while their centres lie within 60
/// degrees of the mean of their energy. Waves more than 60 degrees off march at 60 degrees; waves
/// that the bed turns beyond 61 degrees fade out. Each group marches twice: without breaking, for
/// `arrival`, and with breaking. Where marches meet, each breaks by the height of all together,
/// with the shares of the march without breaking. Waves outside `bands.waves` do not count.
/// progress is called after every few columns of a march. Throws Error invalid_value for settings
/// out of range. The bits are the same for any number of threads.
EnergyMaps march_energy(const BedGrid& bed_height, const ShoreBands& bands,
                        const DirectionalSpectrum& spectrum, const Water& water,
                        const MarchSettings& settings, ThreadPool& pool,
                        const ShoreProgress& progress = {});

}  // namespace ocean
