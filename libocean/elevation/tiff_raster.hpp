// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Reads GeoTIFF by libtiff, in the calling process. Only this part links libtiff, which is not safe
// against hostile files: the program calls it in a child process.
#pragma once

#include <istream>

#include "raster.hpp"

namespace ocean::elevation {

/// Reads the first image of a TIFF: one band of integers of 8, 16 or 32 bits or of floats of 32 or
/// 64 bits; strips or tiles, either byte order, BigTIFF, each lossless compression of the library.
/// Checks all sizes before it reads. Throws RasterFault.
void read_tiff(std::istream& stream, const RasterReceiver& receiver);

}  // namespace ocean::elevation
