// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The input of the gullies' loop over points: plain data, so that the files compiled for one
// instruction set need nothing of the standard library.
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/simd/simd_level.hpp"

namespace ocean {

class GullyFilter;

/// GullyOctave of shaders/land/gullies.glsl, and the lattice in double.
struct GullyOctaveTask {
    double points_per_metre;  // 1 / wavelength
    double count;             // lattice points of a period, or 0
    double periods_per_point;
    float height;
    float steepness;
    float weight;
    std::uint32_t key;
    std::uint32_t last;
};

/// GullyRule of shaders/land/gullies.glsl, and the octaves that have a share.
struct GullyTask {
    float flat_square;
    float roundness;
    float mean;
    float short_mean;
    float profile;
    float wear_scale;
    int octaves;
    GullyOctaveTask octave[12];
};

GullyTask make_gully_task(const GullyFilter& filter, double cell);

/// Arrays of `count` values; masks may be null.
struct GullyArrays {
    std::size_t count;
    const double* x;
    const double* y;
    float* height;
    float* slope_x;
    float* slope_y;
    float* wear;
    float* gully;
    float* ridge;
};

using GullyLoop = void (*)(const GullyTask&, const GullyArrays&);

/// Returns the loop of an instruction set that is compiled in.
GullyLoop gully_loop(SimdLevel level);

/// Added to a double x, |x| < 2^51: x + kRoundDouble - kRoundDouble is the nearest integer, and the
/// low 32 bits of the sum are the integer's.
inline constexpr double kRoundDouble = 6755399441055744.0;  // 1.5 * 2^52

}  // namespace ocean
