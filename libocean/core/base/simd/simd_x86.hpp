// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Lanes of 256 and of 512 bits, whose instructions differ in one number. Included by simd_avx2.hpp
// and simd_avx512.hpp, which define OCEAN_MM.
#pragma once

namespace ocean::OCEAN_KERNEL {

/// Returns a b + c; fms a b - c, fnma c - a b; rounded once.
OCEAN_INLINE Vec fma(Vec a, Vec b, Vec c) {
    return Lanes(OCEAN_MM(fmadd_ps)(a.v, b.v, c.v));
}
OCEAN_INLINE Vec fms(Vec a, Vec b, Vec c) {
    return Lanes(OCEAN_MM(fmsub_ps)(a.v, b.v, c.v));
}
OCEAN_INLINE Vec fnma(Vec a, Vec b, Vec c) {
    return Lanes(OCEAN_MM(fnmadd_ps)(a.v, b.v, c.v));
}
OCEAN_INLINE Vec min(Vec a, Vec b) {
    return Lanes(OCEAN_MM(min_ps)(a.v, b.v));
}
OCEAN_INLINE Vec max(Vec a, Vec b) {
    return Lanes(OCEAN_MM(max_ps)(a.v, b.v));
}
/// Stores past the caches, to memory.
OCEAN_INLINE void stream(float* p, Vec x) {
    OCEAN_MM(stream_ps)(p, x.v);
}
OCEAN_INLINE void finish_streams() {
    _mm_sfence();
}

/// Interleaves per quad: a0 b0 a1 b1; a2 b2 a3 b3.
OCEAN_INLINE Vec unpack_low(Vec a, Vec b) {
    return Lanes(OCEAN_MM(unpacklo_ps)(a.v, b.v));
}
OCEAN_INLINE Vec unpack_high(Vec a, Vec b) {
    return Lanes(OCEAN_MM(unpackhi_ps)(a.v, b.v));
}
/// Returns, per quad, two chosen floats of a, then two of b.
template <int k0, int k1, int k2, int k3>
OCEAN_INLINE Vec pick(Vec a, Vec b) {
    return Lanes(OCEAN_MM(shuffle_ps)(a.v, b.v, k0 | k1 << 2 | k2 << 4 | k3 << 6));
}

}  // namespace ocean::OCEAN_KERNEL
