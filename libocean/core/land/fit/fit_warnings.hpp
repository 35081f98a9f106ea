// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The warnings of a fit: what the terrain does not keep of its elevation model.
#pragma once

#include "ocean/internal/elevation.hpp"
#include "ocean/internal/terrain_fit.hpp"

namespace ocean {

/// Adds to fit.warnings a sentence for each property of the model that the finished fit lacks.
void add_warnings(const ElevationModel& bed, TerrainFit& fit);

}  // namespace ocean
