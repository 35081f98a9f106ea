// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The plot of `ocean terrain fit --plot`: on the left the density of the elevation model and of the
// terrain with the scatter of its seeds, below it their difference; on the right both as shaded
// relief, to one scale.
#pragma once

#include <string>

#include "ocean/internal/terrain_fit.hpp"

namespace ocean::app {

/// Returns the bytes of a PNG file; `name` is part of its title.
std::string plot_fit(const ElevationModel& bed, const TerrainFit& fit, const std::string& name,
                     int threads);

}  // namespace ocean::app
