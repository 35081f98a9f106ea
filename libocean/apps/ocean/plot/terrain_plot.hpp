// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The plot of `ocean spectrum TERRAIN --plot`: the density that the law asks for, that of the tile
// and the scatter of seeds, their difference below, and the tile as shaded relief.
#pragma once

#include <span>
#include <string>

#include "ocean/internal/terrain_rings.hpp"
#include "ocean/terrain.hpp"

namespace ocean::app {

/// Returns the bytes of a PNG file; `name` is part of its title, `seeds` the number of those made.
std::string plot_terrain(Terrain& land, std::span<const TerrainRing> rings, int seeds,
                         const std::string& name);

}  // namespace ocean::app
