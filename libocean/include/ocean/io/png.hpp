// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Pictures for screens.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace ocean::io {

/// Red, green and blue of sRGB, 8 bits each, row after row, the bottom row first. Atomic. Throws
/// Error output.
void write_png(const std::string& path, int width, int height, std::span<const std::uint8_t> rgb);

}  // namespace ocean::io
