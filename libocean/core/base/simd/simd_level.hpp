// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The instruction set that the kernels use. The library contains code for each; the choice is made
// at run time, once.
#pragma once

#include <string_view>

namespace ocean {

enum class SimdLevel {
    portable,  // four lanes in plain C++: NEON on ARM
    sse4,      // x86-64-v2, four lanes
    avx2,      // x86-64-v3 (AVX2, FMA), eight lanes
    avx512,    // x86-64-v4 (AVX-512 F, BW, DQ, VL), sixteen lanes
};

/// Returns the best level of this machine, but no better than the environment variable OCEAN_SIMD =
/// portable, sse4, avx2 or avx512 allows; any other word is not a limit. Reads the environment
/// once. Throws Error(unsupported) if no level that is compiled in remains.
SimdLevel simd_level();
/// Returns true if the level is compiled in and supported by this machine.
bool simd_available(SimdLevel level);
std::string_view simd_name(SimdLevel level);

}  // namespace ocean
