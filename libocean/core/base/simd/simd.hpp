// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The vector type of the kernels: kLanes floats, with the arithmetic of a float. The parts that
// depend on the instruction set are in simd_avx512.hpp, simd_avx2.hpp and simd_4.hpp; the compiler
// flags of the including file select one of them.
//
// Everything is in a namespace named after the instruction set, and everything is inlined: the
// linker must not share a function compiled for one machine with code for another. Products are
// fused with sums only by fma, so that all machines give the same bits.
#pragma once

#include <cstddef>
#include <cstdint>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

#if defined(OCEAN_KERNEL_OUTLINED)  // with sanitizers, whose checks would make huge functions
#define OCEAN_INLINE inline
#define OCEAN_INLINE_LAMBDA
#else
#define OCEAN_INLINE [[gnu::always_inline]] inline
#define OCEAN_INLINE_LAMBDA __attribute__((always_inline))
#endif

#if defined(__AVX512F__)
#define OCEAN_KERNEL avx512
#elif defined(__AVX2__)
#define OCEAN_KERNEL avx2
#elif defined(__SSE4_2__)
#define OCEAN_KERNEL sse4
#else
#define OCEAN_KERNEL portable
#endif

namespace ocean::OCEAN_KERNEL {

#if defined(__AVX512F__)
inline constexpr int kLanes = 16;
#elif defined(__AVX2__)
inline constexpr int kLanes = 8;
#else
inline constexpr int kLanes = 4;
#endif

using Lanes = float __attribute__((vector_size(4 * kLanes)));
using IntLanes = std::int32_t __attribute__((vector_size(4 * kLanes)));

struct Vec {
    Lanes v;

    Vec() = default;
    OCEAN_INLINE Vec(Lanes lanes) : v(lanes) {}
    // Subtracting zero changes no bit, so the compiler makes a plain broadcast of it.
    OCEAN_INLINE Vec(float x) : v(x - Lanes{}) {}
    OCEAN_INLINE explicit Vec(double x) : Vec(static_cast<float>(x)) {}
};

OCEAN_INLINE Vec operator+(Vec a, Vec b) {
    return a.v + b.v;
}
OCEAN_INLINE Vec operator-(Vec a, Vec b) {
    return a.v - b.v;
}
OCEAN_INLINE Vec operator*(Vec a, Vec b) {
    return a.v * b.v;
}
OCEAN_INLINE Vec operator/(Vec a, Vec b) {
    return a.v / b.v;
}
OCEAN_INLINE Vec operator-(Vec a) {
    return -a.v;
}

OCEAN_INLINE Vec load(const float* p) {
    return *reinterpret_cast<const Lanes*>(p);
}
OCEAN_INLINE void store(float* p, Vec x) {
    *reinterpret_cast<Lanes*>(p) = x.v;
}
OCEAN_INLINE Vec load_unaligned(const float* p) {
    Lanes lanes;
    __builtin_memcpy(&lanes, p, sizeof(lanes));
    return lanes;
}
OCEAN_INLINE void store_unaligned(float* p, Vec x) {
    __builtin_memcpy(p, &x.v, sizeof(x.v));
}
OCEAN_INLINE bool is_aligned(const float* p) {
    return reinterpret_cast<std::uintptr_t>(p) % sizeof(Lanes) == 0;
}
/// Stores a few floats past the caches, if the machine can.
OCEAN_INLINE void stream_part(float* to, const float* from, int count) {
#if defined(__SSE2__)
    const auto stream_one = [](float* target, const float* value) OCEAN_INLINE_LAMBDA {
        int bits;
        __builtin_memcpy(&bits, value, sizeof(bits));
        _mm_stream_si32(reinterpret_cast<int*>(target), bits);
    };
    while (count > 0 && reinterpret_cast<std::uintptr_t>(to) % 16 != 0) {
        stream_one(to++, from++);
        --count;
    }
    for (; count >= 4; count -= 4, to += 4, from += 4) _mm_stream_ps(to, _mm_loadu_ps(from));
    for (; count > 0; --count) stream_one(to++, from++);
#else
    __builtin_memcpy(to, from, static_cast<std::size_t>(count) * sizeof(float));
#endif
}

}  // namespace ocean::OCEAN_KERNEL

#if defined(__AVX512F__)
#include "simd_avx512.hpp"
#elif defined(__AVX2__)
#include "simd_avx2.hpp"
#else
#include "simd_4.hpp"
#endif

namespace ocean::OCEAN_KERNEL {

/// rate * tau modulo 1, within a few 1e-8 for any tau that double holds to the millisecond: an fma
/// finds the rounding error of the high product before its integer part is dropped.
struct PhaseClock {
    Vec tau_high;
    Vec tau_low;

    OCEAN_INLINE explicit PhaseClock(double tau)
        : tau_high(static_cast<float>(tau)),
          tau_low(static_cast<float>(tau - static_cast<double>(static_cast<float>(tau)))) {}
    OCEAN_INLINE Vec turns(Vec rate_high, Vec rate_low) const {
        const Vec product = rate_high * tau_high;
        Vec rest = fms(rate_high, tau_high, product);
        rest = fma(rate_high, tau_low, rest);
        rest = fma(rate_low, tau_high, rest);
        return (product - nearest(product)) + rest;
    }
};

struct Complex {
    Vec re;
    Vec im;
};

OCEAN_INLINE Complex operator+(Complex a, Complex b) {
    return {a.re + b.re, a.im + b.im};
}
OCEAN_INLINE Complex operator-(Complex a, Complex b) {
    return {a.re - b.re, a.im - b.im};
}
/// Returns a (c + i s).
OCEAN_INLINE Complex turned(Complex a, float c, float s) {
    return {fms(a.re, c, a.im * Vec(s)), fma(a.re, s, a.im * Vec(c))};
}

OCEAN_INLINE Complex load_complex(const float* p) {
    return {load(p), load(p + kLanes)};
}
OCEAN_INLINE void store_complex(float* p, Complex x) {
    store(p, x.re);
    store(p + kLanes, x.im);
}

/// Returns 1 / sqrt(x) of a normal x > 0, to 2e-7 relative; a large number for 0. Three steps of
/// Newton's method start from a straight line through the logarithm, which a float's bits
/// approximate. That is faster than a square root and a division and, unlike the machines' own
/// estimates, gives the same bits on all machines.
OCEAN_INLINE Vec inversesqrt(Vec x) {
    const IntLanes bits = reinterpret_cast<IntLanes>(x.v);
    Vec y(reinterpret_cast<Lanes>(0x5f375a86 - (bits >> 1)));
    const Vec half = x * Vec(0.5f);
    for (int step = 0; step < 3; ++step) y = y * fnma(half * y, y, 1.5f);
    return y;
}

struct SinCosLanes {
    Vec sine;
    Vec cosine;
};

/// Sine and cosine of at most a few turns: reduced to |y| <= pi/4, then minimax polynomials.
/// Largest error 1.1e-7 [measured].
OCEAN_INLINE SinCosLanes sin_cos(Vec turns) {
    const Vec quarter = nearest(turns * Vec(4.0f));
    const Vec y = fnma(quarter, 0.25f, turns) * Vec(6.28318530718f);
    const Vec y2 = y * y;
    Vec s = fma(y2, -1.9515295891e-4f, 8.3321608736e-3f);
    s = fma(s, y2, -1.6666654611e-1f);
    s = fma(s * y2, y, y);
    Vec c = fma(y2, 2.443315711809948e-5f, -1.388731625493765e-3f);
    c = fma(c, y2, 4.166664568298827e-2f);
    c = fma(c, y2, -0.5f);
    c = fma(c, y2, 1.0f);
    const IntLanes q = __builtin_convertvector(quarter.v, IntLanes);
    const IntLanes odd = (q & 1) != 0;
    const Lanes sine = odd ? c.v : s.v;
    const Lanes cosine = odd ? s.v : c.v;
    // The sign is bit 1 of q for the sine and of q + 1 for the cosine.
    const IntLanes sine_sign = (q & 2) << 30;
    const IntLanes cosine_sign = ((q + 1) & 2) << 30;
    return {Vec(reinterpret_cast<Lanes>(reinterpret_cast<IntLanes>(sine) ^ sine_sign)),
            Vec(reinterpret_cast<Lanes>(reinterpret_cast<IntLanes>(cosine) ^ cosine_sign))};
}

/// x^y for 0 <= x <= 1 and 0 < y <= 8, to 2.5e-6 relative, and 0 below 1e-38: 2^(y log2 x), with
/// the logarithm by the odd series of the inverse hyperbolic tangent between sqrt(1/2) and sqrt(2).
OCEAN_INLINE Vec pow(Vec x, Vec y) {
    const IntLanes bits = reinterpret_cast<IntLanes>(x.v);
    const IntLanes exponent = (bits - 0x3f3504f3) >> 23;
    const Vec mantissa(reinterpret_cast<Lanes>(bits - (exponent << 23)));
    const Vec t = (mantissa - Vec(1.0f)) / (mantissa + Vec(1.0f));
    const Vec t2 = t * t;
    Vec series = fma(t2, 0.320598898f, 0.412198583f);  // 2 / (9 ln 2), 2 / (7 ln 2) ...
    series = fma(series, t2, 0.577078016f);
    series = fma(series, t2, 0.961796694f);
    series = fma(series, t2, 2.885390082f);
    const Vec log2 = fma(series, t, Vec(__builtin_convertvector(exponent, Lanes)));
    const Vec power = max(y * log2, Vec(-126.0f));
    const Vec whole = nearest(power);
    const Vec z = (power - whole) * Vec(0.693147181f);
    Vec exponential = fma(z, 1.98412698e-4f, 1.38888889e-3f);  // 1 / 7!, 1 / 6! ...
    exponential = fma(exponential, z, 8.33333333e-3f);
    exponential = fma(exponential, z, 4.16666667e-2f);
    exponential = fma(exponential, z, 1.66666667e-1f);
    exponential = fma(exponential, z, 0.5f);
    exponential = fma(exponential, z, 1.0f);
    exponential = fma(exponential, z, 1.0f);
    const IntLanes scale = (__builtin_convertvector(whole.v, IntLanes) + 127) << 23;
    const Vec result = exponential * Vec(reinterpret_cast<Lanes>(scale));
    return Vec(x.v > Lanes{} ? result.v : Lanes{});
}

}  // namespace ocean::OCEAN_KERNEL
