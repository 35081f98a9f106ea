// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The input of streams: the land of the waves as heights, uplift and outlets for each level of
// their pyramid; and their output, carved land with the bed of the sea around it.
#pragma once

#include <vector>

#include "field/spline_grid.hpp"
#include "ocean/internal/stream_power.hpp"
#include "ocean/terrain_model.hpp"

namespace ocean {

/// Returns the source of a terrain whose heights before erosion are base + offset on the samples of
/// `domain`, which are the centres of the finest cells. Outlets are the seas below `level` [m] that
/// reach the border; a land without such a sea drains over its border, at the height of its lowest
/// place. The shore and the uplift follow waves of at least a 64th of the land, so that all levels
/// agree on them. `base` and `pool` must outlive the source.
StreamSource stream_source(const TerrainModel& terrain, const SplinePyramid& base, double offset,
                           const Domain& domain, double level, ThreadPool& pool);

/// Returns the carved heights. Its outlets have the bed of the sea: the uncarved land below
/// `level`.
std::vector<float> with_sea_bed(const StreamLand& land, const SplinePyramid& base, double offset,
                                const Domain& domain, double level, ThreadPool& pool);

/// Returns true if two terrains have the same streams: they differ only in later steps.
bool same_streams(const TerrainModel& a, const TerrainModel& b);

}  // namespace ocean
