// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Reads heights from images: grey PNG by libpng, one channel of OpenEXR. The program calls these
// functions in a child process.
#pragma once

#include <istream>
#include <string>

#include "raster.hpp"

namespace ocean::elevation {

/// Reads a grey PNG of 8 or 16 bits; samples are 0 .. RasterFacts::full_scale. Throws RasterFault.
void read_png(std::istream& stream, const RasterReceiver& receiver);
/// Reads the channel Y, else `height`, else the first. Throws RasterFault.
void read_exr(const std::string& path, const RasterReceiver& receiver);

}  // namespace ocean::elevation
