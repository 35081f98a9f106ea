// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Pictures for screens, and grey maps of whole numbers.
#pragma once

#include <cstdint>
#include <span>
#include <string>

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

}  // namespace ocean::io
