// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// SRTM tiles (.hgt): big-endian integers of 16 bits over one degree by one, without a header. The
// size of the file gives the sides, its name the corner.
#pragma once

#include <array>
#include <istream>

#include "raster.hpp"

namespace ocean::elevation {

/// Reads a tile of `bytes` bytes whose south-west sample lies at `corner` [degrees east, degrees
/// north]. Throws RasterFault.
void read_hgt(std::istream& stream, std::uint64_t bytes, const std::array<double, 2>& corner,
              const RasterReceiver& receiver);

}  // namespace ocean::elevation
