// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// `ocean spectrum` of a terrain: its rings as CSV, and their plot.
#pragma once

#include <span>
#include <string>

#include "ocean/internal/terrain_rings.hpp"

namespace ocean::app {

/// Returns the rings as a table with a header line.
std::string terrain_rings_csv(std::span<const TerrainRing> rings);

}  // namespace ocean::app
