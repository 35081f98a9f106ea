// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Sixteen lanes by AVX-512. A "quad" is 128 bits, four neighbouring floats; the unpacking
// instructions work within each quad. Included by simd.hpp.
#pragma once

#include <cstddef>

#define OCEAN_MM(name) _mm512_##name
#include "simd_x86.hpp"

namespace ocean::OCEAN_KERNEL {

/// Returns the nearest integer, ties to even.
OCEAN_INLINE Vec nearest(Vec x) {
    return Lanes(_mm512_roundscale_ps(x.v, _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC));
}
/// Returns true if a lane of a is below b.
OCEAN_INLINE bool any_below(Vec a, Vec b) {
    return _mm512_cmp_ps_mask(a.v, b.v, _CMP_LT_OQ) != 0;
}
/// Loads quad q from p[q * 4 * stride .. + 3].
OCEAN_INLINE Vec load_quads(const float* p, std::size_t stride) {
    __m512 v = _mm512_castps128_ps512(_mm_load_ps(p));
    v = _mm512_insertf32x4(v, _mm_load_ps(p + 4 * stride), 1);
    v = _mm512_insertf32x4(v, _mm_load_ps(p + 8 * stride), 2);
    return Lanes(_mm512_insertf32x4(v, _mm_load_ps(p + 12 * stride), 3));
}

/// For each lane of the result, a lane of a (0 .. 15) or of b (16 .. 31).
struct LaneChoice {
    alignas(64) int lane[16];
};
OCEAN_INLINE Vec choose(Vec a, Vec b, const LaneChoice& choice) {
    return Lanes(_mm512_permutex2var_ps(a.v, _mm512_load_si512(choice.lane), b.v));
}

/// Returns the lanes of vector `part` of n interleaved components: float f = 16 part + lane is
/// component f mod n of sample f / n. Components 0 and 1 are chosen first (of a and b), then
/// component 2 (of b).
constexpr LaneChoice interleaving(int n, int part, bool third) {
    LaneChoice choice{};
    for (int lane = 0; lane < 16; ++lane) {
        const int sample = (16 * part + lane) / n;
        const int component = (16 * part + lane) % n;
        choice.lane[lane] = !third          ? sample + 16 * (component % 2)
                            : component < 2 ? lane
                                            : sample + 16;
    }
    return choice;
}
/// Returns the lanes that make vector `part` of the pairs (x y) and (z w): x y z w of four samples.
constexpr LaneChoice pairing(int part) {
    LaneChoice choice{};
    for (int lane = 0; lane < 16; ++lane) {
        const int sample = (lane / 4 + 4 * part) % 8;
        choice.lane[lane] = 2 * sample + lane % 2 + (lane % 4 < 2 ? 0 : 16);
    }
    return choice;
}
inline constexpr LaneChoice kPairs2[] = {interleaving(2, 0, false), interleaving(2, 1, false)};
inline constexpr LaneChoice kFirstTwo[] = {interleaving(3, 0, false), interleaving(3, 1, false),
                                           interleaving(3, 2, false)};
inline constexpr LaneChoice kThird[] = {interleaving(3, 0, true), interleaving(3, 1, true),
                                        interleaving(3, 2, true)};
inline constexpr LaneChoice kPairing[] = {pairing(0), pairing(1)};

OCEAN_INLINE void interleave_lanes(Vec (&c)[2]) {
    const Vec x = c[0], y = c[1];
    for (int part = 0; part < 2; ++part) c[part] = choose(x, y, kPairs2[part]);
}
OCEAN_INLINE void interleave_lanes(Vec (&c)[3]) {
    const Vec x = c[0], y = c[1], z = c[2];
    for (int part = 0; part < 3; ++part) {
        c[part] = choose(choose(x, y, kFirstTwo[part]), z, kThird[part]);
    }
}
OCEAN_INLINE void interleave_lanes(Vec (&c)[4]) {
    Vec xy[2] = {c[0], c[1]};
    Vec zw[2] = {c[2], c[3]};
    interleave_lanes(xy);
    interleave_lanes(zw);
    for (int part = 0; part < 4; ++part) {
        c[part] = choose(xy[part / 2], zw[part / 2], kPairing[part % 2]);
    }
}

}  // namespace ocean::OCEAN_KERNEL
