// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The work of ocean-raster, which is executed by `ocean terrain import`, which receives the
// raster as its standard output.
#pragma once

#include <span>

namespace ocean {

/// Reads the raster of the arguments "FILE [facts | WEST SOUTH COLUMNS ROWS]" by GDAL, and writes
/// it or its fault to standard output. The window is counted in cells from the south-west. Returns
/// the exit status.
int send_raster(std::span<const char* const> arguments);

}  // namespace ocean
