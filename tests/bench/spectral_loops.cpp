// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The rivals' spectra at one time. This file is compiled once for each instruction set, named by
// OCEAN_BENCH_LOOPS, with contraction to FMA: straight loops that GCC vectorises whole.
#include <cmath>

#include "rival_modes.hpp"

namespace ocean::bench {

namespace {

struct Wave {
    float re, im;
};

/// sine and cosine of x turns, |x| <= 1/2, to 1.2e-7: the nearest quarter turn is taken off, a
/// polynomial serves what is left, |y| <= pi / 4 (coefficients of Cephes' sinf and cosf).
inline void sine_and_cosine(float x, float& sine, float& cosine) {
    const float quarters = __builtin_rintf(4.0f * x);
    const float y = (x - 0.25f * quarters) * 6.28318530718f;
    const float y2 = y * y;
    const float s =
        y * (1.0f + y2 * (-1.6666654611e-1f + y2 * (8.3321608736e-3f + y2 * -1.9515295891e-4f)));
    const float c =
        1.0f - 0.5f * y2 +
        y2 * y2 *
            (4.166664568298827e-2f + y2 * (-1.388731625493765e-3f + y2 * 2.443315711809948e-5f));
    const int quadrant = static_cast<int>(quarters) & 3;
    const float first = (quadrant & 1) != 0 ? c : s;
    const float second = (quadrant & 1) != 0 ? s : c;
    sine = quadrant >= 2 ? -first : first;
    cosine = quadrant == 1 || quadrant == 2 ? -second : second;
}

/// h of mode n. The phase is rate * tau in two floats each, whole turns taken off the large part.
inline Wave wave(const SpectralRow& r, int n) {
    const float product = r.rate_high[n] * r.tau_high;
    const float rest = __builtin_fmaf(r.rate_high[n], r.tau_high, -product) +
                       (r.rate_high[n] * r.tau_low + r.rate_low[n] * r.tau_high);
    float sine, cosine;
    sine_and_cosine((product - __builtin_rintf(product)) + rest, sine, cosine);
    return {r.p_re[n] * cosine + r.q_re[n] * sine, r.p_im[n] * cosine + r.q_im[n] * sine};
}

inline void store(float* spectrum, int n, float re, float im) {
    spectrum[2 * n] = re;
    spectrum[2 * n + 1] = im;
}

/// A field of height, D = -i k e h, slope = i k h with e the displacement.
template <bool gradients>
void planes(const SpectralRow& row, float* spectra, std::ptrdiff_t plane) {
    const SpectralRow r = row;  // not to be read again after each store
    float* const height = spectra;
    float* const displacement_x = height + plane;
    float* const displacement_y = displacement_x + plane;
    float* const slope_x = displacement_y + plane;
    float* const slope_y = slope_x + plane;
    float* const gradient_xx = slope_y + (gradients ? plane : 0);
    float* const gradient_yy = gradient_xx + (gradients ? plane : 0);
    float* const gradient_xy = gradient_yy + (gradients ? plane : 0);
#pragma GCC ivdep
    for (int n = 0; n < r.count; ++n) {
        const Wave h = wave(r, n);
        const float kx = r.kx[n];
        const float ex = kx * r.displacement[n];
        const float ey = r.ky * r.displacement[n];
        store(height, n, h.re, h.im);
        store(displacement_x, n, ex * h.im, -ex * h.re);
        store(displacement_y, n, ey * h.im, -ey * h.re);
        store(slope_x, n, -kx * h.im, kx * h.re);
        store(slope_y, n, -r.ky * h.im, r.ky * h.re);
        if constexpr (gradients) {
            const float xx = kx * ex, yy = r.ky * ey, xy = kx * ey;
            store(gradient_xx, n, xx * h.re, xx * h.im);
            store(gradient_yy, n, yy * h.re, yy * h.im);
            store(gradient_xy, n, xy * h.re, xy * h.im);
        }
    }
}

/// The same, two real fields A and B as the real and imaginary part of one: the spectrum of
/// A + i B over all k.
template <bool gradients>
void pairs(const SpectralRow& row, float* spectra, std::ptrdiff_t plane) {
    const SpectralRow r = row;
    float* const height = spectra;  // and gradient xy
    float* const displacement = height + plane;
    float* const slope = displacement + plane;
    float* const gradient = slope + (gradients ? plane : 0);  // xx and yy
#pragma GCC ivdep
    for (int n = 0; n < r.count; ++n) {
        const Wave h = wave(r, n);
        const float kx = r.kx[n];
        const float ex = kx * r.displacement[n];
        const float ey = r.ky * r.displacement[n];
        store(displacement, n, ey * h.re + ex * h.im, ey * h.im - ex * h.re);
        store(slope, n, -r.ky * h.re - kx * h.im, kx * h.re - r.ky * h.im);
        if constexpr (gradients) {
            const float xx = kx * ex, yy = r.ky * ey, xy = kx * ey;
            store(height, n, h.re - xy * h.im, h.im + xy * h.re);
            store(gradient, n, xx * h.re - yy * h.im, xx * h.im + yy * h.re);
        } else {
            store(height, n, h.re, h.im);
        }
    }
}

}  // namespace

extern const SpectralLoops OCEAN_BENCH_LOOPS;
const SpectralLoops OCEAN_BENCH_LOOPS = {planes<false>, planes<true>, pairs<false>, pairs<true>};

}  // namespace ocean::bench
