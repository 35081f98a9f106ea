// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// From a mode's start to its state at one time. Needs turns.glsl.
// Rates are in turns per unit of tau: cycles per second with tau in seconds, or, in a looping
// sea, whole turns per loop with tau the fraction of the loop. Both come as a sum of two floats.

struct ModeState {
    real re;       // h(k, t) [m]
    real im;
    real rate_re;  // d h / d t, in metres per unit of tau and per 2 pi
    real rate_im;
};

// The first half of the digits of x, so that products of halves are exact. [Dekker 1971] section 5
// with splitter = 2^12 + 1, in double 2^27 + 1.
formula real leading_half(real x) {
    precise real wide = x * real(splitter);
    precise real rest = wide - x;
    precise real half_x = wide - rest;
    return half_x;
}

// a * b - product, exactly, where product is a * b rounded. Not by fma(), which GLSL does not
// promise to round once: unfused, the phase is lost within the hour.
formula real product_error(real a, real b, real product) {
    precise real a1 = leading_half(a);
    precise real a2 = a - a1;
    precise real b1 = leading_half(b);
    precise real b2 = b - b1;
    precise real e1 = a1 * b1 - product;
    precise real e2 = e1 + a1 * b2;
    precise real e3 = e2 + a2 * b1;
    precise real error = e3 + a2 * b2;
    return error;
}

// rate * tau modulo 1, as exact at tau = 1e6 s as at 1 s: the product of the high parts is kept
// whole until its integer part is dropped.
formula real phase_turns(real rate_high, real rate_low, real tau_high, real tau_low) {
    precise real product = rate_high * tau_high;
    precise real whole = floor(product + real(0.5));
    precise real fraction = product - whole;
    precise real rest = product_error(rate_high, tau_high, product);
    precise real low = rest + (rate_high * tau_low + rate_low * tau_high);
    precise real turns = fraction + low;
    return turns;
}

// h(k,t) = h0(k) e^(-i w t) + conj(h0(-k)) e^(+i w t): energy of h0(k) travels along +k.
// [Tessendorf 2001] eq. 43 with the sign of time turned. (a, b) = h0(k), (c, d) = h0(-k),
// rate = w / (2 pi). The second result is its time derivative.
formula ModeState mode_state(real a, real b, real c, real d, real turns, real rate) {
    SinCos phase = sin_cos_turns(turns);
    precise real forward_re = a * phase.cosine + b * phase.sine;
    precise real forward_im = b * phase.cosine - a * phase.sine;
    precise real mirror_re = c * phase.cosine + d * phase.sine;
    precise real mirror_im = c * phase.sine - d * phase.cosine;
    precise ModeState state;
    state.re = forward_re + mirror_re;
    state.im = forward_im + mirror_im;
    state.rate_re = rate * (forward_im - mirror_im);
    state.rate_im = rate * (mirror_re - forward_re);
    return state;
}
