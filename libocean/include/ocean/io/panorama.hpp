// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Light from all around as photographers measure it and painters make it: pictures over longitude
// and latitude.
#pragma once

#include <string>
#include <vector>

namespace ocean::io {

struct Panorama {
    int width = 0;           // twice the height
    int height = 0;          // even
    std::vector<float> rgb;  // 0 .. 65504, row after row, the bottom row first
};

/// Channels R, G and B of an EXR file of one part, of any codec, at most 8192 x 4096. Light that is
/// negative or no number is taken as none, more than half floats hold as the most they do. threads:
/// 0 = the cores this process may use. Throws Error bad_file with the reason; safe on hostile
/// files.
Panorama read_exr_panorama(const std::string& path, int threads = 0);

}  // namespace ocean::io
