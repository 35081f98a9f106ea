// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Raw floats (.flt) with the text of their header (.hdr): rows from the north, 4 bytes a height.
#pragma once

#include <istream>
#include <string>
#include <string_view>

#include "grid_header.hpp"
#include "ocean/internal/elevation_file.hpp"

namespace ocean::elevation {

/// Returns the header of a .hdr file; keys that grids do not have are skipped. Throws Error
/// bad_file.
GridHeader parse_float_header(std::string_view text, const std::string& name);

/// Reads the floats of a stream of `bytes` bytes. Throws as read_elevation, and Error bad_file if
/// the header states another size.
ElevationModel read_float_grid(const GridHeader& header, std::istream& floats, std::uint64_t bytes,
                               const std::string& name, const std::string& crs,
                               const ElevationOptions& options);

}  // namespace ocean::elevation
