// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The report of `ocean terrain fit`, as text, JSON and CSV.
#pragma once

#include <string>

#include "ocean/internal/terrain_fit.hpp"

namespace ocean::app {

/// The first line of files of rings that the command writes.
inline constexpr char kRingsHeader[] = "wavenumber,density,count,model,scatter,residual\n";

/// Returns the law that the terrain has: table, broken or one.
std::string law_name(const TerrainFit& fit);
std::string fit_text(const ElevationModel& bed, const TerrainFit& fit);
/// Returns one JSON object.
std::string fit_json(const ElevationModel& bed, const TerrainFit& fit);
/// Returns a row for each ring: [rad/m], [m^4], waves, [m^4], log10, log10.
std::string rings_csv(const TerrainFit& fit);

}  // namespace ocean::app
