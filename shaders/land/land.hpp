// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// shaders/land/ seen from C++: the very files that the GPU compiles, once in float and once in
// double. This page gives them the few GLSL words that C++ lacks.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace ocean::land {

using uint = std::uint32_t;
using std::abs;
using std::floor;
using std::max;
using std::min;
using std::sqrt;

#define formula inline
namespace single_precision {
using real = float;
#include "land/gullies.glsl"
}  // namespace single_precision

namespace double_precision {
using real = double;
#include "land/gullies.glsl"
}  // namespace double_precision
#undef formula

}  // namespace ocean::land
