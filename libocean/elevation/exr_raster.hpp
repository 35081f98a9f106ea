// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Reads heights from one channel of an OpenEXR image. The program calls it in a child process.
#pragma once

#include <string>

#include "raster.hpp"

namespace ocean::elevation {

/// Reads the channel whose name says height: `height` or `elevation`, else Z, Y, `depth` or R, else
/// the only one; never alpha. Throws RasterFault, also if several may be meant and differ.
void read_exr(const std::string& path, const RasterReceiver& receiver);

}  // namespace ocean::elevation
