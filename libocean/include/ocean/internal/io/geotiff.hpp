// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// GeoTIFF: heights in [m] as 32-bit floats on a metre grid, for GIS programs. Samples are points
// (GTRasterType PixelIsPoint): sample (i, j) lies at the domain's place(i, j), and a program that
// draws cells centres a cell there. The first row is the northern one. The header has the
// provenance as lines of ImageDescription.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ocean/io/image.hpp"

namespace ocean::io {

/// Writes the first plane of an image in tiles that are deflated after the predictor for floats. An
/// image that wraps has no repeated row or column. Throws Error output, and invalid_value for an
/// image without a plane or a domain. Needs libtiff.
void write_geotiff(const Image& image, const std::string& path);
/// Returns an upper bound of the size of a GeoTIFF without its header strings [bytes].
std::uint64_t max_geotiff_bytes(const Domain& domain);

/// Passes the samples of a GeoTIFF that write_geotiff wrote to `sink`, rows from the north. Throws
/// Error bad_file for a file that is damaged or has other samples than `domain`. Needs libtiff.
void read_geotiff(const std::string& path, const Domain& domain, const ByteSink& sink);

/// Returns the header strings that write_geotiff wrote, without libtiff. Throws Error bad_file for
/// a file without them, for a damaged one, and for a file that is not a TIFF.
std::vector<HeaderString> read_geotiff_header(const std::string& path);

}  // namespace ocean::io
