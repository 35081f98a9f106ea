// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// POV-Ray's height_field: a 16-bit grey PNG, with the far row on top. An image that wraps has
// a column and a row more than samples, which close the seam.
//     height = base + scale * code / 65536
// The heights fill three quarters of the codes, so that the error is at most (hi - lo) / 98304.
#pragma once

#include <cstdint>
#include <string>

#include "ocean/io/image.hpp"

namespace ocean::io {

/// Writes an image whose first plane holds the heights [m]. Its header has the strings of the image
/// and, as tEXt, Description and ocean:range, the heights of code 0 and of code 65535; a sea's file
/// has none of these strings. Throws Error output, and invalid_value for a height that is not
/// finite.
void write_height_field(const Image& image, const std::string& path);
/// Returns the text of the .txt beside the image: lo, hi, unit, quantum, and POV-Ray's scale and
/// base.
std::string height_field_description(const Image& image);
/// Returns the text of the .inc beside the image: scale and base for scenes.
std::string height_field_declarations(const Image& image);
/// Returns an upper bound of the size of the PNG without the strings of its header [bytes].
std::uint64_t max_height_field_bytes(const Domain& domain);

/// Passes the 16-bit codes of a height field to `sink`, rows from the top, little-endian. Throws
/// Error bad_file.
void read_height_field(const std::string& path, const ByteSink& sink);

}  // namespace ocean::io
