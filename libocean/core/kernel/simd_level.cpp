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

namespace avx512 {
extern const KernelCode kCode;
}
namespace avx2 {
extern const KernelCode kCode;
}
namespace sse4 {
extern const KernelCode kCode;
}
namespace portable {
extern const KernelCode kCode;
}

namespace {

/// A compiled-in kernel with the processor features that it requires: bits as in Processor.
struct Kernel {
    SimdLevel level;
    const KernelCode* code;
    unsigned leaf_1, leaf_7, saved_states;
};

#if defined(OCEAN_X86_KERNELS)
[[maybe_unused]] constexpr unsigned kAvxStates = 0x06;     // of XMM and YMM registers
[[maybe_unused]] constexpr unsigned kAvx512States = 0xE6;  // and of masks and ZMM
[[maybe_unused]] constexpr unsigned kAvx512 =
    bit_AVX512F | bit_AVX512BW | bit_AVX512DQ | bit_AVX512VL;
#endif

/// The best first. A build may leave out any but the last: OCEAN_KERNELS in CMake.
constexpr Kernel kKernels[] = {
#if defined(OCEAN_KERNEL_AVX512)
    {SimdLevel::avx512, &avx512::kCode, bit_FMA, bit_AVX2 | kAvx512, kAvx512States},
#endif
#if defined(OCEAN_KERNEL_AVX2)
    {SimdLevel::avx2, &avx2::kCode, bit_FMA, bit_AVX2, kAvxStates},
#endif
#if defined(OCEAN_KERNEL_SSE4)
    {SimdLevel::sse4, &sse4::kCode, bit_SSE4_2, 0, 0},
#endif
    {SimdLevel::portable, &portable::kCode, 0, 0, 0},
};

/// The features of the processor whose registers the system saves between threads. [Intel SDM] vol.
/// 1 sec. 14.3, 15.2. The compilers' own function is missing from some of their run-time libraries.
struct Processor {
    unsigned leaf_1 = 0;        // ecx of cpuid 1
    unsigned leaf_7 = 0;        // ebx of cpuid 7
    unsigned saved_states = 0;  // XCR0

    Processor() {
#if defined(OCEAN_X86_KERNELS)
        unsigned eax = 0, ebx = 0, ecx = 0, edx = 0;
        if (__get_cpuid(1, &eax, &ebx, &ecx, &edx) != 0) leaf_1 = ecx;
        if (__get_cpuid_count(7, 0, &eax, &ebx, &ecx, &edx) != 0) leaf_7 = ebx;
        if ((leaf_1 & bit_OSXSAVE) != 0) {
            __asm__ volatile("xgetbv" : "=a"(saved_states), "=d"(edx) : "c"(0));
        }
#endif
    }
    bool runs(const Kernel& kernel) const {
        return (leaf_1 & kernel.leaf_1) == kernel.leaf_1 &&
               (leaf_7 & kernel.leaf_7) == kernel.leaf_7 &&
               (saved_states & kernel.saved_states) == kernel.saved_states;
    }
};

SimdLevel choose() {
    const char* word = std::getenv("OCEAN_SIMD");
    const std::string_view limit = word != nullptr ? word : "";
    SimdLevel most = SimdLevel::avx512;
    for (const SimdLevel level : {SimdLevel::portable, SimdLevel::sse4, SimdLevel::avx2}) {
        if (simd_name(level) == limit) most = level;
    }
    const Processor processor;
    for (const Kernel& kernel : kKernels) {
        if (kernel.level <= most && processor.runs(kernel)) return kernel.level;
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
    for (const Kernel& kernel : kKernels) {
        if (kernel.level == level) return Processor().runs(kernel);
    }
    return false;
}

SimdLevel simd_level() {
    static const SimdLevel chosen = choose();
    return chosen;
}

const KernelCode& kernel_code(SimdLevel level) {
    for (const Kernel& kernel : kKernels) {
        if (kernel.level == level) return *kernel.code;
    }
    return portable::kCode;
}

}  // namespace ocean
