// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Sine and cosine of an angle given in turns (1 turn = 2 pi rad). Angles stay in turns until
// here because the reduction of a turn to a quarter is exact in binary arithmetic.

struct SinCos {
    real sine;
    real cosine;
};

// Any finite number of turns. Reduced to |r| <= 1/8 turn, then the Taylor series of sine and
// cosine to x^15 and x^16: truncation below 1e-16. Written out so that the bits do not depend on
// a platform's sin and cos, and precise, so that they do not on a driver's compiler either. Proved
// against the C library in noise_test.cpp.
formula SinCos sin_cos_turns(real turns) {
    precise real quarter = floor(real(4.0) * turns + real(0.5));
    precise real x = (turns - real(0.25) * quarter) * real(6.283185307179586);
    precise real q = x * x;
    precise real s = real(-1.0 / 1307674368000.0);
    s = s * q + real(1.0 / 6227020800.0);
    s = s * q - real(1.0 / 39916800.0);
    s = s * q + real(1.0 / 362880.0);
    s = s * q - real(1.0 / 5040.0);
    s = s * q + real(1.0 / 120.0);
    s = s * q - real(1.0 / 6.0);
    s = x + x * q * s;
    precise real c = real(1.0 / 20922789888000.0);
    c = c * q - real(1.0 / 87178291200.0);
    c = c * q + real(1.0 / 479001600.0);
    c = c * q - real(1.0 / 3628800.0);
    c = c * q + real(1.0 / 40320.0);
    c = c * q - real(1.0 / 720.0);
    c = c * q + real(1.0 / 24.0);
    c = c * q - real(0.5);
    c = c * q + real(1.0);
    precise real which = quarter - real(4.0) * floor(real(0.25) * quarter);  // 0, 1, 2 or 3
    SinCos result;
    if (which == real(0.0)) {
        result.sine = s;
        result.cosine = c;
    } else if (which == real(1.0)) {
        result.sine = c;
        result.cosine = -s;
    } else if (which == real(2.0)) {
        result.sine = -s;
        result.cosine = -c;
    } else {
        result.sine = -c;
        result.cosine = s;
    }
    return result;
}
