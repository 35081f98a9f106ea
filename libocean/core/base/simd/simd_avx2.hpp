// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Eight lanes by AVX2 and FMA. A "quad" is 128 bits, four neighbouring floats; the unpacking
// instructions work within each quad. Included by simd.hpp.
#pragma once

#include <cstddef>

#define OCEAN_MM(name) _mm256_##name
#include "simd_x86.hpp"

namespace ocean::OCEAN_KERNEL {

/// Returns the nearest integer, ties to even.
OCEAN_INLINE Vec nearest(Vec x) {
    return Lanes(_mm256_round_ps(x.v, _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC));
}
/// Returns true if a lane of a is below b.
OCEAN_INLINE bool any_below(Vec a, Vec b) {
    return _mm256_movemask_ps(_mm256_cmp_ps(a.v, b.v, _CMP_LT_OQ)) != 0;
}
/// Loads quad q from p[q * 4 * stride .. + 3].
OCEAN_INLINE Vec load_quads(const float* p, std::size_t stride) {
    const __m256 v = _mm256_castps128_ps256(_mm_load_ps(p));
    return Lanes(_mm256_insertf128_ps(v, _mm_load_ps(p + 4 * stride), 1));
}

/// Returns the low (0) or high (1) quad of a, then of b.
template <int kFromA, int kFromB>
OCEAN_INLINE Vec pick_quads(Vec a, Vec b) {
    return Lanes(_mm256_permute2f128_ps(a.v, b.v, kFromA | (kFromB + 2) << 4));
}

/// Reorders q[0] .. q[n - 1]: quad 0 of each, then quad 1 of each.
OCEAN_INLINE void interleave_quads(Vec (&q)[2]) {
    const Vec low = pick_quads<0, 0>(q[0], q[1]);
    q[1] = pick_quads<1, 1>(q[0], q[1]);
    q[0] = low;
}
OCEAN_INLINE void interleave_quads(Vec (&q)[3]) {
    const Vec first = pick_quads<0, 0>(q[0], q[1]);
    const Vec second = pick_quads<0, 1>(q[2], q[0]);
    q[2] = pick_quads<1, 1>(q[1], q[2]);
    q[0] = first;
    q[1] = second;
}
OCEAN_INLINE void interleave_quads(Vec (&q)[4]) {
    const Vec low01 = pick_quads<0, 0>(q[0], q[1]);
    const Vec low23 = pick_quads<0, 0>(q[2], q[3]);
    const Vec high01 = pick_quads<1, 1>(q[0], q[1]);
    q[3] = pick_quads<1, 1>(q[2], q[3]);
    q[0] = low01;
    q[1] = low23;
    q[2] = high01;
}

}  // namespace ocean::OCEAN_KERNEL
