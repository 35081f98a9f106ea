// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Gaussian noise as a pure function of (seed, cascade, n, m): the start of every mode, the same
// on CPU and GPU, for any grid and in any order. Counter-based: nothing is stepped or stored.
// Needs turns.glsl. Symbols: n, m are the signed integer wavenumbers of the mode.

struct RandomBits {
    uint a;
    uint b;
    uint c;
    uint d;
};

struct Gaussian {
    real re;
    real im;
};

// Philox-4x32-10 [Salmon 2011] section 3.3: ten rounds of multiply, swap and key bump turn a
// counter into four independent 32-bit words. Proved by the known answers in noise_test.cpp.
formula RandomBits philox_4x32(uint c0, uint c1, uint c2, uint c3, uint key0, uint key1) {
    for (int round = 0; round < 10; ++round) {
        uint high0;
        uint low0;
        uint high1;
        uint low1;
        umulExtended(0xD2511F53u, c0, high0, low0);
        umulExtended(0xCD9E8D57u, c2, high1, low1);
        c0 = high1 ^ c1 ^ key0;
        c1 = low1;
        c2 = high0 ^ c3 ^ key1;
        c3 = low0;
        key0 += 0x9E3779B9u;
        key1 += 0xBB67AE85u;
    }
    RandomBits bits;
    bits.a = c0;
    bits.b = c1;
    bits.c = c2;
    bits.d = c3;
    return bits;
}

// 2 artanh(s) by its power series, for |s| <= 3 - 2 sqrt(2) = 0.1716: ln((1 + s) / (1 - s)).
formula real two_artanh(real s) {
    real q = s * s;
    real sum = real(1.0 / 21.0);
    sum = sum * q + real(1.0 / 19.0);
    sum = sum * q + real(1.0 / 17.0);
    sum = sum * q + real(1.0 / 15.0);
    sum = sum * q + real(1.0 / 13.0);
    sum = sum * q + real(1.0 / 11.0);
    sum = sum * q + real(1.0 / 9.0);
    sum = sum * q + real(1.0 / 7.0);
    sum = sum * q + real(1.0 / 5.0);
    sum = sum * q + real(1.0 / 3.0);
    sum = sum * q + real(1.0);
    return real(2.0) * s * sum;
}

// -ln(u) for u = (x + 1/2) / 2^32, which is never 0 and never 1: range 1.2e-10 .. 22.9.
// Written out so that the bits do not depend on a platform's log. Near u = 1 it starts from
// 1 - u, an exact integer, so that small radii keep their relative accuracy in float too.
formula real minus_log_uniform(uint x) {
    if (x >= 3037000500u) {  // u > sqrt(1/2)
        real gap = (real(0xFFFFFFFFu - x) + real(0.5)) * real(2.3283064365386963e-10);
        return two_artanh(gap / (real(2.0) - gap));
    }
    real t = real(x) + real(0.5);
    int exponent = x == 0u ? -1 : findMSB(x);
    real mantissa = ldexp(t, -exponent);
    if (mantissa > real(1.4142135623730951)) {
        mantissa = real(0.5) * mantissa;
        exponent += 1;
    }
    real log_mantissa = two_artanh((mantissa - real(1.0)) / (mantissa + real(1.0)));
    return real(32 - exponent) * real(0.6931471805599453) - log_mantissa;
}

// Two independent standard normal numbers by the transform of [Box and Muller 1958] eq. 1.
// The largest magnitude is sqrt(2 * 22.9) = 6.8; nothing is clamped.
formula Gaussian gaussian_noise(uint seed, uint cascade, int n, int m) {
    RandomBits bits = philox_4x32(uint(n), uint(m), cascade, 0u, seed, 0x6F636561u);
    real radius = sqrt(real(2.0) * minus_log_uniform(bits.a));
    SinCos angle = sin_cos_turns(real(bits.b) * real(2.3283064365386963e-10));
    Gaussian xi;
    xi.re = radius * angle.cosine;
    xi.im = radius * angle.sine;
    return xi;
}
