// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Loops that do one thing to memory or to the multipliers, as fast as the machine can: what no
// frame can be faster than. Compiled once for each instruction set, like spectral_loops.cpp.
#include <immintrin.h>

#include "machine_speed.hpp"

namespace ocean::bench {

namespace {

#ifdef __AVX512F__
constexpr int kBytes = 64;
using Lanes = __m512;
inline void stream(float* to, Lanes value) {
    _mm512_stream_ps(to, value);
}
inline Lanes load(const float* from) {
    return _mm512_load_ps(from);
}
#else
constexpr int kBytes = 32;
using Lanes = __m256;
inline void stream(float* to, Lanes value) {
    _mm256_stream_ps(to, value);
}
inline Lanes load(const float* from) {
    return _mm256_load_ps(from);
}
#endif
constexpr std::size_t kLanes = kBytes / sizeof(float);

void copy(const float* from, float* to, std::size_t count) {
    for (std::size_t i = 0; i < count; i += 4 * kLanes) {
        for (std::size_t l = 0; l < 4 * kLanes; l += kLanes) stream(to + i + l, load(from + i + l));
    }
    _mm_sfence();
}

void fill(float* to, std::size_t count) {
    const Lanes value = Lanes{} + 1.0f;
    for (std::size_t i = 0; i < count; i += kLanes) stream(to + i, value);
    _mm_sfence();
}

float sum(const float* from, std::size_t count) {
    Lanes sums[8] = {};
    for (std::size_t i = 0; i < count; i += 8 * kLanes) {
        for (std::size_t l = 0; l < 8; ++l) sums[l] += load(from + i + l * kLanes);
    }
    float result = 0.0f;
    for (const Lanes& lanes : sums) {
        for (std::size_t l = 0; l < kLanes; ++l) result += lanes[l];
    }
    return result;
}

/// count * kFmaFlops operations in twelve chains: more than latency times ports.
float fma_chain(std::size_t count) {
    Lanes chains[12];
    for (Lanes& chain : chains) {
        chain = Lanes{};
        asm volatile("" : "+v"(chain));  // each its own: twelve equal ones would become one
    }
    Lanes factor = Lanes{} + 0.5f;
    Lanes addend = Lanes{} + 1.0f;
    asm volatile("" : "+v"(factor), "+v"(addend));
    for (std::size_t i = 0; i < count; ++i) {
#pragma GCC unroll 12
        for (Lanes& chain : chains) chain = chain * factor + addend;
    }
    float result = 0.0f;
    for (const Lanes& chain : chains) result += chain[0];
    return result;
}

}  // namespace

extern const MachineLoops OCEAN_BENCH_MACHINE;
const MachineLoops OCEAN_BENCH_MACHINE = {copy, fill, sum, fma_chain, 12.0 * 2.0 * kLanes};

}  // namespace ocean::bench
