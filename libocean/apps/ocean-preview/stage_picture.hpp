// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Pictures of the stages between the modes and the maps: h0, h(k, t), the plan of the transform.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/gl/stages.hpp"
#include "ocean/ocean.hpp"

namespace ocean::app {

/// "h0", "spectrum", "butterfly".
std::vector<std::string> stage_picture_names();
bool is_stage_picture(const std::string& view);
/// Returns the names of the renderer's views, and then those of the stages.
std::vector<std::string> all_view_names();

/// Pixels in red, green and blue of sRGB, the bottom row first.
struct StagePicture {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgb;
    /// Waves to each side of k = 0 that have 95 % of a plane's energy; 0 for a plan.
    int middle = 0;
};

/// Returns a stage of one of the sea's cascades:
///   h0, spectrum  a pixel for each wavenumber, k = 0 in the middle; the colour's angle is the
///                 phase, its brightness the logarithm of the amplitude over four decades
///   butterfly     a column for each stage: red and green are the root, blue where it reads
/// Throws Error; no_gpu without OpenGL 4.3.
StagePicture make_stage_picture(gl::StageMaker& maker, Ocean& sea, double time, std::size_t cascade,
                                std::string_view name);

}  // namespace ocean::app
