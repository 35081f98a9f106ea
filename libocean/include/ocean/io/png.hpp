// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Pictures for screens, and grey maps of whole numbers.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/io/provenance.hpp"

namespace ocean::io {

/// Red, green and blue of sRGB, 8 bits each, row after row, the bottom row first. Atomic. Throws
/// Error output.
void write_png(const std::string& path, int width, int height, std::span<const std::uint8_t> rgb);

/// Grey of 16 bits, proportional to the value, not to a screen's: for masks and textures. Rows and
/// errors as above.
void write_grey_png(const std::string& path, int width, int height,
                    std::span<const std::uint16_t> grey);
/// The bytes of that file.
std::string grey_png(int width, int height, std::span<const std::uint16_t> grey);

/// Returns the bytes of a PNG file with texts in its header. Needs a PNG file.
std::string with_png_strings(std::string_view png, std::span<const HeaderString> strings);
/// Returns the texts whose names begin with "ocean:". Throws Error bad_file for a file that has
/// none, is damaged or no PNG.
std::vector<HeaderString> read_png_header(const std::string& path);

}  // namespace ocean::io
