// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Pictures of the stages of a sea between the modes and the maps (h0, h(k, t), the plan of the
// transform) and of a terrain from white noise to its heights (noise, its transform, the filter,
// the filtered transform).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "ocean/internal/gl/stages.hpp"
#include "ocean/internal/terrain_stages.hpp"
#include "ocean/ocean.hpp"

namespace ocean::app {

/// Pixels in red, green and blue of sRGB, the bottom row first.
struct StagePicture {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgb;
    /// Waves to each side of k = 0 that have 95 % of a plane's energy; 0: it has no such middle.
    int middle = 0;
    bool is_plane = false;  // a square without a middle, shown whole
};

/// Returns a stage of one of the sea's cascades:
///   h0, spectrum  a pixel for each wavenumber, k = 0 in the middle; the colour's angle is the
///                 phase, its brightness the logarithm of the amplitude over four decades
///   butterfly     a column for each stage: red and green are the root, blue where it reads
/// Throws Error; no_gpu without OpenGL 4.3.
StagePicture make_stage_picture(gl::StageMaker& maker, Ocean& sea, double time, std::size_t cascade,
                                std::string_view name);

/// Returns a stage of a terrain in grey, a pixel for each sample or wave:
///   noise      white noise in space, three standard deviations from black to grey and to white
///   transform  the magnitude of its Fourier transform, k = 0 in the middle, over 2.5 decades
///   filter     the filter of each wave, 1/f^beta of a simple law, from its lowest to its highest
///              value in decades
///   spectrum   the filtered transform in the same greys
StagePicture make_stage_picture(const TerrainStages& stages, std::string_view name);

/// Returns a picture of that size. A plane of wavenumbers stands left as a whole, and right its
/// middle, with 95 % of the energy, as large as fits; a frame marks the middle in the whole. A plan
/// of the transform fills the picture. A plane that is larger than its half shows the brightest
/// pixel of each square. A plane without a middle stands alone, as large as fits; where it is
/// larger than the picture, a pixel is the mean of a square.
StagePicture laid_out(const StagePicture& stage, int width, int height);

}  // namespace ocean::app
