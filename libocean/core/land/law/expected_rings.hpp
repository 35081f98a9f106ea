// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The mean over all seeds of the rings that measure_rings() finds, computed without making a seed.
#pragma once

#include <array>
#include <vector>

#include "ocean/internal/ring_spectrum.hpp"
#include "ocean/terrain_model.hpp"
#include "ocean/thread_pool.hpp"

namespace ocean {

/// Returns the expected density of each ring that measure_rings finds with a Hann window in a part
/// of `samples` samples of the terrain's tile, relative if the terrain's law is (see
/// TerrainLaw::is_absolute). Rings without waves are left out. The removal of the plane is ignored:
/// it lowers only the first rings. `options` has limits.
std::vector<double> expected_rings(const TerrainModel& terrain, const std::array<int, 2>& samples,
                                   const RingOptions& options, ThreadPool& pool);

}  // namespace ocean
