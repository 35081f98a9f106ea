// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// shaders/wave/ seen from C++: the very files that the GPU compiles, once in float and once in
// double. This page gives them the few GLSL words that C++ lacks.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace ocean::wave {

using uint = std::uint32_t;
using std::abs;
using std::cosh;
using std::erfc;
using std::exp;
using std::floor;
using std::ldexp;
using std::max;
using std::min;
using std::pow;
using std::sqrt;
using std::tanh;

inline void umulExtended(uint x, uint y, uint& high, uint& low) {
    const std::uint64_t product = static_cast<std::uint64_t>(x) * y;
    high = static_cast<uint>(product >> 32);
    low = static_cast<uint>(product);
}
inline float inversesqrt(float x) {
    return 1.0f / sqrt(x);
}
inline double inversesqrt(double x) {
    return 1.0 / sqrt(x);
}
inline int findMSB(uint x) {
    return 31 - std::countl_zero(x);
}

// A formula is a function that both compilers may see many times.
#define precise
#define formula inline
namespace single_precision {
using real = float;
inline constexpr float splitter = 4097.0f;
#include "wave/turns.glsl"

#include "wave/noise.glsl"

#include "wave/copies.glsl"
#include "wave/crest_light.glsl"
#include "wave/dispersion.glsl"
#include "wave/foam_cover.glsl"
#include "wave/foam_lace.glsl"
#include "wave/haze.glsl"
#include "wave/horizon.glsl"
#include "wave/phase.glsl"
#include "wave/reflectance.glsl"
#include "wave/slope_tiles.glsl"
#include "wave/surface.glsl"
#include "wave/visible_slope.glsl"
}  // namespace single_precision

namespace double_precision {
using real = double;
inline constexpr double splitter = 134217729.0;
#include "wave/turns.glsl"

#include "wave/noise.glsl"

#include "wave/copies.glsl"
#include "wave/crest_light.glsl"
#include "wave/dispersion.glsl"
#include "wave/foam_cover.glsl"
#include "wave/foam_lace.glsl"
#include "wave/haze.glsl"
#include "wave/horizon.glsl"
#include "wave/phase.glsl"
#include "wave/reflectance.glsl"
#include "wave/slope_tiles.glsl"
#include "wave/surface.glsl"
#include "wave/visible_slope.glsl"
}  // namespace double_precision
#undef precise
#undef formula

}  // namespace ocean::wave
