// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The plots that commands draw, as the bytes of PNG files, and the string by which a command knows
// those that it has written. `name` is part of a title.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "ocean/internal/io/provenance.hpp"
#include "ocean/internal/terrain_fit.hpp"
#include "ocean/internal/terrain_rings.hpp"
#include "ocean/ocean.hpp"
#include "ocean/terrain.hpp"

namespace ocean::app {

/// `ocean spectrum`: on the left the frequency spectrum as asked and as the grid resolves it, on
/// the right the directional spectrum.
std::string plot_spectrum(Ocean& ocean, const std::string& name, int threads);

/// `ocean spectrum TERRAIN`: the density that the law asks for, that of the tile and the scatter of
/// `seeds` seeds, their difference below, and the tile as shaded relief.
std::string plot_terrain(Terrain& land, std::span<const TerrainRing> rings, int seeds,
                         const std::string& name);

/// `ocean terrain fit`: on the left the density of the elevation model and of the terrain with the
/// scatter of its seeds, below it their difference; on the right both as shaded relief, to one
/// scale.
std::string plot_fit(const ElevationModel& bed, const TerrainFit& fit, const std::string& name,
                     int threads);

/// Returns the string that marks a plot of a command.
io::HeaderString plot_mark(std::string_view command);
/// Returns true for a PNG file with the mark of the command, which may replace it.
bool is_plot(const std::string& path, std::string_view command);

}  // namespace ocean::app
