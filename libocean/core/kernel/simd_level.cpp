// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The choice among the kernels that are compiled in.
#include "simd_level.hpp"

#include <cstdlib>

#if defined(OCEAN_X86_KERNELS)
#include <cpuid.h>
#endif

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

#if defined(OCEAN_X86_KERNELS)
namespace {

/// What the processor can and the system saves between threads. [Intel SDM] vol. 1 sec. 14.3, 15.2;
/// the compilers' own question for it is missing from some of their run-time libraries.
struct Processor {
    unsigned leaf_1 = 0;        // ecx of cpuid 1
    unsigned leaf_7 = 0;        // ebx of cpuid 7
    unsigned saved_states = 0;  // XCR0

    Processor() {
        unsigned eax = 0, ebx = 0, ecx = 0, edx = 0;
        if (__get_cpuid(1, &eax, &ebx, &ecx, &edx) != 0) leaf_1 = ecx;
        if (__get_cpuid_count(7, 0, &eax, &ebx, &ecx, &edx) != 0) leaf_7 = ebx;
        if ((leaf_1 & bit_OSXSAVE) != 0) {
            __asm__ volatile("xgetbv" : "=a"(saved_states), "=d"(edx) : "c"(0));
        }
    }
    bool has(unsigned in_leaf_1, unsigned in_leaf_7, unsigned states) const {
        return (leaf_1 & in_leaf_1) == in_leaf_1 && (leaf_7 & in_leaf_7) == in_leaf_7 &&
               (saved_states & states) == states;
    }
};

}  // namespace

bool simd_available(SimdLevel level) {
    constexpr unsigned kAvxStates = 0x06;     // of XMM and YMM registers
    constexpr unsigned kAvx512States = 0xE6;  // and of masks and ZMM
    constexpr unsigned kAvx512 = bit_AVX512F | bit_AVX512BW | bit_AVX512DQ | bit_AVX512VL;
    const Processor processor;
    switch (level) {
        case SimdLevel::avx512:
            return processor.has(bit_FMA, bit_AVX2 | kAvx512, kAvx512States);
        case SimdLevel::avx2:
            return processor.has(bit_FMA, bit_AVX2, kAvxStates);
        case SimdLevel::sse4:
            return processor.has(bit_SSE4_2, 0, 0);
        case SimdLevel::portable:
            break;
    }
    return true;
}
#else
bool simd_available(SimdLevel level) {
    return level == SimdLevel::portable;
}
#endif

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
