// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The classic way to a fractional surface, step by step, for tests and teaching: white noise in
// space, its Fourier transform, the filter, and the transform back, by the radix-2 transform in
// double. The noise belongs to the terrain's own waves, so that the last step is the terrain's
// height.
#pragma once

#include <vector>

#include "ocean/enum_words.hpp"
#include "ocean/terrain.hpp"

namespace ocean {

/// A step of the synthesis. The words are the values of `ocean terrain --stage`.
enum class TerrainStep { noise, transform, filter, filtered, height };

/// Planes of resolution^2 values, row-major [j][i]. Planes of waves have k = 0 in the middle, at
/// sample (N/2, N/2), with kx to the right and ky up.
struct TerrainStages {
    int resolution = 0;
    std::vector<float> noise;      // white, in space: mean 0, variance 1 over all seeds
    std::vector<float> transform;  // |X| / N of its forward transform X: 1 in the mean square
    std::vector<float> filter;     // the filter, gain sqrt(S) dk [m]
    std::vector<float> filtered;   // |h| of each wave [m]
    std::vector<float> height;     // the sum of the waves and the mean height [m]
};

/// Returns all steps of the land's terrain at its own resolution. The height differs from
/// Terrain::surface by rounding alone, 2e-6 of rms. Throws Error out_of_memory.
TerrainStages terrain_stages(Terrain& land);
/// Returns the plane of a step.
const std::vector<float>& plane_of(const TerrainStages& stages, TerrainStep step);

}  // namespace ocean
