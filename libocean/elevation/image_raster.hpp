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
/// Reads the channel whose name says height: `height` or `elevation`, else Z, Y, `depth` or R, else
/// the only one; never alpha. Throws RasterFault, also if several may be meant and differ.
void read_exr(const std::string& path, const RasterReceiver& receiver);

}  // namespace ocean::elevation
