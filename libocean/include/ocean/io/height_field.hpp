// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// POV-Ray's height_field: a 16-bit grey PNG of an image of one plane, of one that wraps (N+1)^2
// pixels with the seam, top row far. height = base + scale * code / 65536; the heights fill three
// quarters of the codes, so each is right to (hi - lo) / 98304.
#pragma once

#include <cstdint>
#include <string>

#include "ocean/io/image.hpp"

namespace ocean::io {

/// Of a square image whose first plane holds the heights in metres. Throws Error output, and
/// invalid_value for a height that is not finite.
void write_height_field(const Image& image, const std::string& path);
/// What goes beside it as .txt: lo, hi, unit, quantum, and POV-Ray's scale and base, for people.
std::string height_field_description(const Image& image);
/// And as .inc: scale and base for scenes.
std::string height_field_declarations(const Image& image);
/// The most bytes of the PNG.
std::uint64_t most_height_field_bytes(int resolution);

/// The 16-bit codes of such a file, rows from the top, little-endian. Throws Error bad_file.
void read_height_field(const std::string& path, const ByteSink& sink);

}  // namespace ocean::io
