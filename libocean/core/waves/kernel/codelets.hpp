// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Short inverse transforms of R points, one line per lane: the straight-line pieces of the kernel's
// passes. One source serves all widths; kernel_test.cpp proves each against the plain sum.
//
//   X_k = sum over j < R of x_j w_R^(j k),   w_R = exp(+2 pi i / R), not normalised.
//
// With R = P Q, j = q + Q p, k = k' + P l (p, k' < P; q, l < Q) the sum becomes
//   X_(k' + P l) = sum_q w_Q^(q l) [ w_R^(q k') sum_p w_P^(p k') x_(q + Q p) ],
// because w_R^(Q p P l) = 1: Q transforms of P points, one factor w_R^(q k') per value ("twiddle"),
// P transforms of Q points. [Cooley and Tukey 1965] eq. 6, [Van Loan 1992] sec. 1.3.
#pragma once

#include "base/simd/simd.hpp"
#include "roots_of_unity.hpp"

namespace ocean::OCEAN_KERNEL {

/// Transforms two points.
OCEAN_INLINE void butterfly(Complex& a, Complex& b) {
    const Complex difference = a - b;
    a = a + b;
    b = difference;
}

/// Transforms four points; a multiplication by i swaps real and imaginary part.
OCEAN_INLINE void butterfly(Complex& a, Complex& b, Complex& c, Complex& d) {
    const Complex even = a + c;
    const Complex even_difference = a - c;
    const Complex odd = b + d;
    const Complex odd_difference = b - d;
    a = even + odd;
    c = even - odd;
    b = {even_difference.re - odd_difference.im, even_difference.im + odd_difference.re};
    d = {even_difference.re + odd_difference.im, even_difference.im - odd_difference.re};
}

/// Transforms eight points as 4 x 2; w_8 and w_8^3 are (+-1 + i) / sqrt(2): two sums and two
/// products.
OCEAN_INLINE void butterfly(Complex (&x)[8]) {
    constexpr float kHalfRoot = 0.70710678118654752f;
    butterfly(x[0], x[2], x[4], x[6]);
    butterfly(x[1], x[3], x[5], x[7]);
    const Complex e0 = x[0], e1 = x[2], e2 = x[4], e3 = x[6];
    const Complex o0 = x[1], o1 = x[3], o2 = x[5], o3 = x[7];
    const Complex turned_1 = {o1.re - o1.im, o1.re + o1.im};  // (1 + i) o1
    const Complex turned_3 = {o3.re + o3.im, o3.re - o3.im};  // (-1 + i) o3, but for a sign
    x[0] = e0 + o0;
    x[4] = e0 - o0;
    x[2] = {e2.re - o2.im, e2.im + o2.re};
    x[6] = {e2.re + o2.im, e2.im - o2.re};
    x[1] = {fma(turned_1.re, kHalfRoot, e1.re), fma(turned_1.im, kHalfRoot, e1.im)};
    x[5] = {fnma(turned_1.re, kHalfRoot, e1.re), fnma(turned_1.im, kHalfRoot, e1.im)};
    x[3] = {fnma(turned_3.re, kHalfRoot, e3.re), fma(turned_3.im, kHalfRoot, e3.im)};
    x[7] = {fma(turned_3.re, kHalfRoot, e3.re), fnma(turned_3.im, kHalfRoot, e3.im)};
}

/// codelet<R>(load, store): load(j) returns x_j, store(k, X_k) receives the results in any order.
/// All of x is read before the first store.
template <int R>
struct Codelet {
    static constexpr int P = R < 32 ? 4 : 8;
    static constexpr int Q = R / P;
    static constexpr RootsOfUnity<R> kRoots{};

    template <typename Load, typename Store>
    OCEAN_INLINE static void run(const Load& load, const Store& store) {
        Complex inner[R];  // [q][k'], twiddled
        inner_transform<0>(load, inner);
        if constexpr (R <= 16) {
#pragma GCC unroll 4
            for (int q = 1; q < Q; ++q) inner_transform<1>(load, inner, q);
#pragma GCC unroll 4
            for (int k = 0; k < P; ++k) outer_transform(inner, k, store);
        } else {  // a loop is faster than code that exceeds the decoder's cache
#pragma GCC unroll 1
            for (int q = 1; q < Q; ++q) inner_transform<1>(load, inner, q);
#pragma GCC unroll 1
            for (int k = 0; k < P; ++k) outer_transform(inner, k, store);
        }
    }

  private:
    template <int kTwiddled, typename Load>
    OCEAN_INLINE static void inner_transform(const Load& load, Complex* inner, int q = 0) {
        Codelet<P>::run([&](int p) OCEAN_INLINE_LAMBDA { return load(q + Q * p); },
                        [&](int k, Complex x) OCEAN_INLINE_LAMBDA {
                            if (kTwiddled == 0 || k == 0) {
                                inner[q * P + k] = x;
                            } else {
                                inner[q * P + k] =
                                    turned(x, kRoots.cosine[q * k], kRoots.sine[q * k]);
                            }
                        });
    }

    template <typename Store>
    OCEAN_INLINE static void outer_transform(const Complex* inner, int k, const Store& store) {
        Codelet<Q>::run([&](int q) OCEAN_INLINE_LAMBDA { return inner[q * P + k]; },
                        [&](int l, Complex x) OCEAN_INLINE_LAMBDA { store(k + P * l, x); });
    }
};

template <>
struct Codelet<2> {
    template <typename Load, typename Store>
    OCEAN_INLINE static void run(const Load& load, const Store& store) {
        Complex a = load(0), b = load(1);
        butterfly(a, b);
        store(0, a);
        store(1, b);
    }
};

template <>
struct Codelet<4> {
    template <typename Load, typename Store>
    OCEAN_INLINE static void run(const Load& load, const Store& store) {
        Complex a = load(0), b = load(1), c = load(2), d = load(3);
        butterfly(a, b, c, d);
        store(0, a);
        store(1, b);
        store(2, c);
        store(3, d);
    }
};

template <>
struct Codelet<8> {
    template <typename Load, typename Store>
    OCEAN_INLINE static void run(const Load& load, const Store& store) {
        Complex x[8];
#pragma GCC unroll 8
        for (int j = 0; j < 8; ++j) x[j] = load(j);
        butterfly(x);
#pragma GCC unroll 8
        for (int k = 0; k < 8; ++k) store(k, x[k]);
    }
};

}  // namespace ocean::OCEAN_KERNEL
