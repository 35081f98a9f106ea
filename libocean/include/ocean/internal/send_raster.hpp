// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The work of the program ocean-raster. `ocean terrain import` executes it and reads the raster
// from its standard output.
#pragma once

#include <span>

namespace ocean {

/// Reads by GDAL the raster that the arguments "FILE [facts | WEST SOUTH COLUMNS ROWS]" name, and
/// writes it or its fault to standard output. The window is counted in cells from the south-west.
/// Returns the exit status.
int send_raster(std::span<const char* const> arguments);

}  // namespace ocean
