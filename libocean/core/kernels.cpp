// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The choice among the kernels that are compiled in. No other file knows which they are.
#include "base/simd/simd_level.hpp"

#include <cstdlib>
#include <string>
#include <string_view>

#if defined(OCEAN_X86_KERNELS)
#include <cpuid.h>
#endif

#include "base/batch_fft_task.hpp"
#include "coast/loops/band_sector_task.hpp"
#include "coast/loops/signal_task.hpp"
#include "hulls/wake_task.hpp"
#include "land/gullies/gullies_task.hpp"
#include "ocean/enum_words.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/text.hpp"
#include "waves/kernel/frame_task.hpp"
#include "waves/modes/mode_rows_task.hpp"

namespace ocean {

/// Declares the code of one kernel, which is defined in the namespace of its name.
#define OCEAN_DECLARE_KERNEL(name)               \
    namespace name {                             \
    extern const KernelCode kCode;               \
    extern const BatchFftLoop kBatchFftLoop;     \
    extern const BandSectorLoop kBandSectorLoop; \
    extern const SignalLoop kSignalLoop;         \
    extern const GullyLoop kGullyLoop;           \
    extern const WakeLoops kWakeLoops;           \
    extern const ModeRowLoops kModeRowLoops;     \
    }
OCEAN_DECLARE_KERNEL(avx512)
OCEAN_DECLARE_KERNEL(avx2)
OCEAN_DECLARE_KERNEL(sse4)
OCEAN_DECLARE_KERNEL(portable)

namespace {

/// A compiled-in kernel with the processor features that it requires: bits as in Processor.
struct Kernel {
    SimdLevel level;
    const KernelCode* code;
    const BatchFftLoop* batch_fft_loop;
    const BandSectorLoop* band_sector_loop;
    const SignalLoop* signal_loop;
    const GullyLoop* gully_loop;
    const WakeLoops* wake_loops;
    const ModeRowLoops* mode_row_loops;
    unsigned leaf_1, leaf_7, saved_states;
};

#if defined(OCEAN_X86_KERNELS)
[[maybe_unused]] constexpr unsigned kAvxStates = 0x06;     // of XMM and YMM registers
[[maybe_unused]] constexpr unsigned kAvx512States = 0xE6;  // and of masks and ZMM
[[maybe_unused]] constexpr unsigned kAvx512 =
    bit_AVX512F | bit_AVX512BW | bit_AVX512DQ | bit_AVX512VL;
#endif

#define OCEAN_KERNEL_ENTRY(name)                                                 \
    SimdLevel::name, &name::kCode, &name::kBatchFftLoop, &name::kBandSectorLoop, \
        &name::kSignalLoop, &name::kGullyLoop, &name::kWakeLoops, &name::kModeRowLoops
/// The best first. A build may leave out any: OCEAN_KERNELS and OCEAN_PORTABLE_KERNEL in CMake.
constexpr Kernel kKernels[] = {
#if defined(OCEAN_KERNEL_AVX512)
    {OCEAN_KERNEL_ENTRY(avx512), bit_FMA, bit_AVX2 | kAvx512, kAvx512States},
#endif
#if defined(OCEAN_KERNEL_AVX2)
    {OCEAN_KERNEL_ENTRY(avx2), bit_FMA, bit_AVX2, kAvxStates},
#endif
#if defined(OCEAN_KERNEL_SSE4)
    {OCEAN_KERNEL_ENTRY(sse4), bit_SSE4_2, 0, 0},
#endif
#if defined(OCEAN_KERNEL_PORTABLE)
    {OCEAN_KERNEL_ENTRY(portable), 0, 0, 0},
#endif
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

/// Throws the error of a build that has no kernel to choose. reason: "... excludes".
[[noreturn]] void throw_no_kernel(const std::string& reason) {
    const std::string names =
        joined(kKernels, ", ", [](const Kernel& kernel) { return simd_name(kernel.level); });
    throw Error(ErrorKind::unsupported,
                "this build has kernels for " + names + " only, which " + reason);
}

/// Returns the highest level that OCEAN_SIMD allows. Throws Error invalid_value.
SimdLevel highest_level(std::string_view limit) {
    if (limit.empty()) return SimdLevel::avx512;
    if (const auto level = enumerator_of<SimdLevel>(limit)) return *level;
    throw Error(ErrorKind::invalid_value, "OCEAN_SIMD = " + std::string(limit) +
                                              ": allowed are portable, sse4, avx2 and avx512");
}

SimdLevel choose() {
    const char* word = std::getenv("OCEAN_SIMD");
    const std::string_view limit = word != nullptr ? word : "";
    const SimdLevel most = highest_level(limit);
    const Processor processor;
    for (const Kernel& kernel : kKernels) {
        if (kernel.level <= most && processor.runs(kernel)) return kernel.level;
    }
    throw_no_kernel(most == SimdLevel::avx512 ? "this processor does not run"
                                              : "OCEAN_SIMD = " + std::string(limit) + " excludes");
}

/// Returns a kernel that is compiled in.
const Kernel& find_kernel(SimdLevel level) {
    for (const Kernel& kernel : kKernels) {
        if (kernel.level == level) return kernel;
    }
    throw Error(ErrorKind::unsupported,
                "this build has no kernel for " + std::string(simd_name(level)));
}

}  // namespace

std::string_view simd_name(SimdLevel level) {
    return word_of(level);
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
    return *find_kernel(level).code;
}
BatchFftLoop batch_fft_loop(SimdLevel level) {
    return *find_kernel(level).batch_fft_loop;
}
BandSectorLoop band_sector_loop(SimdLevel level) {
    return *find_kernel(level).band_sector_loop;
}
SignalLoop signal_loop(SimdLevel level) {
    return *find_kernel(level).signal_loop;
}
GullyLoop gully_loop(SimdLevel level) {
    return *find_kernel(level).gully_loop;
}
WakeLoops wake_loops(SimdLevel level) {
    return *find_kernel(level).wake_loops;
}
const ModeRowLoops& mode_row_loops(SimdLevel level) {
    return *find_kernel(level).mode_row_loops;
}

}  // namespace ocean
