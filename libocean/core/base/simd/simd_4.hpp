// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Four lanes for every other machine, by the compiler's own vectors: SSE on x86, NEON on ARM.
// Included by simd.hpp.
#pragma once

#include <cstddef>
#include <cstdint>

#if defined(__ARM_FEATURE_FMA)
#include <arm_neon.h>
#endif

namespace ocean::OCEAN_KERNEL {

/// Returns true if a lane is true, which has all bits set.
OCEAN_INLINE bool any(IntLanes lanes) {
#if defined(__SSE2__)
    return _mm_movemask_ps(reinterpret_cast<__m128>(lanes)) != 0;
#else
    return (lanes[0] | lanes[1] | lanes[2] | lanes[3]) != 0;
#endif
}

/// Returns a b + c, rounded once: the sums are rounded to odd before they are rounded to floats, so
/// that none seems to lie halfway between two floats [Boldo and Melquiond 2008].
[[gnu::noinline, gnu::cold]] inline Vec fma_by_odd(Vec a, Vec b, Vec c) {
    Vec result;
    for (int lane = 0; lane < kLanes; ++lane) {
        const double product = static_cast<double>(a.v[lane]) * static_cast<double>(b.v[lane]);
        const auto addend = static_cast<double>(c.v[lane]);
        double sum = product + addend;
        const double rest = sum - product;
        const double error = (product - (sum - rest)) + (addend - rest);  // exact
        std::int64_t bits;
        __builtin_memcpy(&bits, &sum, sizeof(bits));
        const bool is_exact = !(error < 0.0 || error > 0.0);
        if (!is_exact && (bits & 1) == 0) bits += (error > 0.0) == (sum > 0.0) ? 1 : -1;
        __builtin_memcpy(&sum, &bits, sizeof(bits));
        result.v[lane] = static_cast<float>(sum);
    }
    return result;
}

/// Returns a b + c. The sum in double is rounded to a float, that is twice: this differs only where
/// the double lies halfway between two floats, or the float is subnormal.
OCEAN_INLINE Vec fma(Vec a, Vec b, Vec c) {
#if defined(__ARM_FEATURE_FMA)
    return Lanes(vfmaq_f32(c.v, a.v, b.v));
#elif defined(__SSE2__)
    const auto upper = [](Vec x)
                           OCEAN_INLINE_LAMBDA { return _mm_cvtps_pd(_mm_movehl_ps(x.v, x.v)); };
    const __m128d low = _mm_cvtps_pd(a.v) * _mm_cvtps_pd(b.v) + _mm_cvtps_pd(c.v);
    const __m128d high = upper(a) * upper(b) + upper(c);
    const Lanes rounded = _mm_movelh_ps(_mm_cvtpd_ps(low), _mm_cvtpd_ps(high));
    const IntLanes last_words = __builtin_shufflevector(
        reinterpret_cast<IntLanes>(low), reinterpret_cast<IntLanes>(high), 0, 2, 4, 6);
    const IntLanes bits = reinterpret_cast<IntLanes>(rounded) & 0x7fffffff;
    const IntLanes doubtful =
        ((last_words & 0x1fffffff) == 0x10000000) | ((bits < 0x00800000) & (bits != 0));
    return __builtin_expect(any(doubtful), 0) ? fma_by_odd(a, b, c) : Vec(rounded);
#else
    return fma_by_odd(a, b, c);
#endif
}
/// Returns a b - c; fnma c - a b.
OCEAN_INLINE Vec fms(Vec a, Vec b, Vec c) {
    return fma(a, b, -c);
}
OCEAN_INLINE Vec fnma(Vec a, Vec b, Vec c) {
    return fma(-a, b, c);
}
OCEAN_INLINE Vec min(Vec a, Vec b) {
    return a.v < b.v ? a.v : b.v;
}
OCEAN_INLINE Vec max(Vec a, Vec b) {
    return a.v > b.v ? a.v : b.v;
}
/// Returns the nearest integer, ties to even.
OCEAN_INLINE Vec nearest(Vec x) {
    constexpr float kWhole = 8388608.0f;  // 2^23: floats from here on are integers
    const IntLanes sign = reinterpret_cast<IntLanes>(x.v) & INT32_MIN;
    const Lanes size = reinterpret_cast<Lanes>(reinterpret_cast<IntLanes>(x.v) ^ sign);
    const Lanes whole = size < kWhole ? (size + kWhole) - kWhole : size;
    return reinterpret_cast<Lanes>(reinterpret_cast<IntLanes>(whole) | sign);
}
/// Returns true if a lane of a is below b.
OCEAN_INLINE bool any_below(Vec a, Vec b) {
    return any(a.v < b.v);
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
