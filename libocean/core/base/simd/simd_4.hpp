// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Four lanes for every other machine, by the compiler's own vectors: SSE on x86, NEON on ARM. They
// may lack a fused multiply-add, so that results differ from AVX2's by rounding. Included by
// simd.hpp.
#pragma once

#include <cstddef>

namespace ocean::OCEAN_KERNEL {

/// a b + c, a b - c, c - a b, rounded twice.
OCEAN_INLINE Vec fma(Vec a, Vec b, Vec c) {
    return a * b + c;
}
OCEAN_INLINE Vec fms(Vec a, Vec b, Vec c) {
    return a * b - c;
}
OCEAN_INLINE Vec fnma(Vec a, Vec b, Vec c) {
    return c - a * b;
}
OCEAN_INLINE Vec min(Vec a, Vec b) {
    return a.v < b.v ? a.v : b.v;
}
OCEAN_INLINE Vec max(Vec a, Vec b) {
    return a.v > b.v ? a.v : b.v;
}
/// The nearest integer of |x| < 2^22, ties to even.
OCEAN_INLINE Vec nearest(Vec x) {
    constexpr float kRound = 12582912.0f;  // 1.5 * 2^23: its last bit counts integers
    return (x + Vec(kRound)) - Vec(kRound);
}
/// Returns true if a lane of a is below b.
OCEAN_INLINE bool any_below(Vec a, Vec b) {
    const IntLanes below = a.v < b.v;
    return (below[0] | below[1] | below[2] | below[3]) != 0;
}
/// Stores past the caches, to memory, if the machine can.
OCEAN_INLINE void stream(float* p, Vec x) {
#if defined(__SSE2__)
    _mm_stream_ps(p, x.v);
#else
    store(p, x);
#endif
}
OCEAN_INLINE void finish_streams() {
#if defined(__SSE2__)
    _mm_sfence();
#endif
}

/// Interleaves: a0 b0 a1 b1; a2 b2 a3 b3.
OCEAN_INLINE Vec unpack_low(Vec a, Vec b) {
    return Lanes(__builtin_shufflevector(a.v, b.v, 0, 4, 1, 5));
}
OCEAN_INLINE Vec unpack_high(Vec a, Vec b) {
    return Lanes(__builtin_shufflevector(a.v, b.v, 2, 6, 3, 7));
}
/// Returns two chosen floats of a, then two of b.
template <int k0, int k1, int k2, int k3>
OCEAN_INLINE Vec pick(Vec a, Vec b) {
    return Lanes(__builtin_shufflevector(a.v, b.v, k0, k1, k2 + 4, k3 + 4));
}
OCEAN_INLINE Vec load_quads(const float* p, std::size_t) {
    return load(p);
}
/// There is one quad, so that nothing changes.
template <int n>
OCEAN_INLINE void interleave_quads(Vec (&)[n]) {}

}  // namespace ocean::OCEAN_KERNEL
