// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Place, system and units of a raster by GDAL and PROJ.
#pragma once

#include <gdal.h>

#include <optional>

#include "raster.hpp"

namespace ocean::elevation {

/// Sets place, system and units of the facts, whose columns and rows are those of the window.
/// Throws RasterFault for a raster that is turned, or not in a plane.
void set_place(GDALDatasetH dataset, const std::optional<GridWindow>& window, RasterFacts& facts);

}  // namespace ocean::elevation
