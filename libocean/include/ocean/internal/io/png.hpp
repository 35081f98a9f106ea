// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// PNG files: sRGB images for screens, and grey images of 16-bit integers for data.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/internal/io/provenance.hpp"

namespace ocean::io {

/// Writes red, green and blue of sRGB, 8 bits each, row-major, the bottom row first. Atomic. Throws
/// Error output.
void write_png(const std::string& path, int width, int height, std::span<const std::uint8_t> rgb);

/// Writes linear grey, 16 bits, row-major, the bottom row first, for masks and textures. Atomic.
/// Throws Error output.
void write_grey_png(const std::string& path, int width, int height,
                    std::span<const std::uint16_t> grey);
/// Returns the bytes of the file that write_grey_png writes.
std::string grey_png(int width, int height, std::span<const std::uint16_t> grey);

/// Returns the bytes of a PNG file with `strings` added to its header. `png` must be a PNG file.
std::string with_png_strings(std::string_view png, std::span<const HeaderString> strings);
/// Returns the bytes of a PNG file with `strings` added as tEXt, which every PNG reader shows. The
/// strings must be Latin-1.
std::string with_png_keywords(std::string_view png, std::span<const HeaderString> strings);
/// Returns the texts whose names begin with "ocean:". Throws Error bad_file for a file without
/// such texts, for a damaged one, and for a file that is not a PNG.
std::vector<HeaderString> read_png_header(const std::string& path);

}  // namespace ocean::io
