// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Environment light: images over longitude and latitude.
#pragma once

#include <string>
#include <vector>

namespace ocean::io {

struct Panorama {
    int width = 0;           // twice the height
    int height = 0;          // even
    std::vector<float> rgb;  // linear, 0 .. 65504, row-major, the bottom row first
};

/// Returns the channels R, G and B of an EXR file of one part, with any codec, at most 8192 x 4096.
/// Negative values and NaN become 0, values above 65504, the limit of half floats, become 65504.
/// `threads`: 0 = the cores this process may use. Throws Error bad_file with the reason; safe on
/// hostile files.
Panorama read_exr_panorama(const std::string& path, int threads = 0);

}  // namespace ocean::io
