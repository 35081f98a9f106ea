// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The choice among the kernels that are compiled in.
#include "simd_level.hpp"

#include <cstdlib>

#include "frame_task.hpp"

namespace ocean {

#if defined(OCEAN_X86_KERNELS)
namespace avx512 {
extern const KernelCode kCode;
}
namespace avx2 {
extern const KernelCode kCode;
}
namespace sse4 {
extern const KernelCode kCode;
}
#endif
namespace portable {
extern const KernelCode kCode;
}

namespace {

constexpr SimdLevel kLevels[] = {SimdLevel::avx512, SimdLevel::avx2, SimdLevel::sse4,
                                 SimdLevel::portable};

SimdLevel choose() {
    const char* word = std::getenv("OCEAN_SIMD");
    const std::string_view limit = word != nullptr ? word : "";
    SimdLevel most = SimdLevel::avx512;
    for (const SimdLevel level : kLevels) {
        if (simd_name(level) == limit) most = level;
    }
    for (const SimdLevel level : kLevels) {
        if (level <= most && simd_available(level)) return level;
    }
    return SimdLevel::portable;
}

}  // namespace

std::string_view simd_name(SimdLevel level) {
    switch (level) {
        case SimdLevel::avx512:
            return "avx512";
        case SimdLevel::avx2:
            return "avx2";
        case SimdLevel::sse4:
            return "sse4";
        case SimdLevel::portable:
            break;
    }
    return "portable";
}

bool simd_available(SimdLevel level) {
#if defined(OCEAN_X86_KERNELS)
    switch (level) {
        case SimdLevel::avx512:
            return __builtin_cpu_supports("avx512f") != 0 &&
                   __builtin_cpu_supports("avx512bw") != 0 &&
                   __builtin_cpu_supports("avx512dq") != 0 &&
                   __builtin_cpu_supports("avx512vl") != 0 && __builtin_cpu_supports("fma") != 0;
        case SimdLevel::avx2:
            return __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0;
        case SimdLevel::sse4:
            return __builtin_cpu_supports("sse4.2") != 0;
        case SimdLevel::portable:
            break;
    }
    return true;
#else
    return level == SimdLevel::portable;
#endif
}

SimdLevel simd_level() {
    static const SimdLevel chosen = choose();
    return chosen;
}

const KernelCode& kernel_code(SimdLevel level) {
#if defined(OCEAN_X86_KERNELS)
    switch (level) {
        case SimdLevel::avx512:
            return avx512::kCode;
        case SimdLevel::avx2:
            return avx2::kCode;
        case SimdLevel::sse4:
            return sse4::kCode;
        case SimdLevel::portable:
            break;
    }
#else
    static_cast<void>(level);
#endif
    return portable::kCode;
}

}  // namespace ocean
