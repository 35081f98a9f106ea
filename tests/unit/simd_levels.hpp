// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "base/simd/simd_level.hpp"

namespace ocean::test {

/// Returns the instruction sets for which there is a kernel and that this machine has.
inline std::vector<SimdLevel> levels() {
    std::vector<SimdLevel> result;
    for (const SimdLevel level :
         {SimdLevel::portable, SimdLevel::sse4, SimdLevel::avx2, SimdLevel::avx512}) {
        if (simd_available(level)) result.push_back(level);
    }
    return result;
}

}  // namespace ocean::test
