// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
// Pass one of a frame: from the modes to their state at one time, from that to the coefficients of
// pairs of fields, and the transform along x. A workgroup has one row of ky.
// Defined outside: N, COLUMNS, PACKS, and COEFFICIENTS_p of each pack, made of the table of linear
// fields: complex numbers of the variables h, h_rate, kx, ky and u below.
#define LINES 1
#include "wave/turns.glsl"
#include "wave/phase.glsl"
#include "compute/complex.glsl"
#include "compute/line_transform.glsl"
#include "compute/packs.glsl"

layout(local_size_x = THREADS) in;

layout(std430, binding = 0) readonly restrict buffer Amplitudes {
    vec2 h0[];  // m, rows of ky in FFT order
};
layout(std430, binding = 1) readonly restrict buffer Rates {
    vec2 rate[];  // the high and the low part; see phase.glsl
};
layout(std430, binding = 2) readonly restrict buffer Displacements {
    float displacement[];  // coth(k d) / k, m
};

layout(location = 0) uniform vec2 tau;               // the high and the low part
layout(location = 1) uniform float rate_factor;      // from turns per tau to radians per second
layout(location = 2) uniform float wavenumber_step;  // rad/m
layout(location = 3) uniform float gradient_scale;  // a power of two

float wavenumber(uint index) {
    return wavenumber_step * float(int(index) - (index < N / 2u ? 0 : N));
}

// The first field's coefficient and i times the second's.
vec2 pair(vec2 a, vec2 b) {
    precise vec2 sum = a + times_i(b);
    return sum;
}

#define FILL_AND_TRANSFORM(PACK, COEFFICIENTS) \
    for (uint e = 0u; e < 8u; ++e) { \
        vec2 h = state[e]; \
        vec2 h_rate = state_rate[e]; \
        float kx = wavenumber(thread + e * THREADS); \
        float u = u_of[e]; \
        precise vec2 coefficient = COEFFICIENTS; \
        v[e] = coefficient; \
    } \
    inverse_transform(v, thread, 0u); \
    for (uint e = 0u; e < 8u; ++e) PACK.value[pack_index(thread + e * THREADS, y)] = v[e]

void main() {
    uint thread = gl_LocalInvocationID.x;
    uint y = gl_WorkGroupID.x;
    uint mirror_row = ((N - y) & (N - 1u)) * N;
    float ky = wavenumber(y);
    vec2 state[8];
    vec2 state_rate[8];
    float u_of[8];
    for (uint e = 0u; e < 8u; ++e) {
        uint x = thread + e * THREADS;
        uint at = y * N + x;
        vec2 own = h0[at];
        vec2 mirror = h0[mirror_row + ((N - x) & (N - 1u))];
        vec2 turn_rate = rate[at];
        float turns = phase_turns(turn_rate.x, turn_rate.y, tau.x, tau.y);
        ModeState mode = mode_state(own.x, own.y, mirror.x, mirror.y, turns,
                                    turn_rate.x * rate_factor);
        state[e] = vec2(mode.re, mode.im);
        state_rate[e] = vec2(mode.rate_re, mode.rate_im);
        u_of[e] = displacement[at];
    }
    vec2 v[8];
    FILL_AND_TRANSFORM(pack_0, COEFFICIENTS_0);
#if PACKS > 1
    FILL_AND_TRANSFORM(pack_1, COEFFICIENTS_1);
#endif
#if PACKS > 2
    FILL_AND_TRANSFORM(pack_2, COEFFICIENTS_2);
#endif
#if PACKS > 3
    FILL_AND_TRANSFORM(pack_3, COEFFICIENTS_3);
#endif
#if PACKS > 4
    FILL_AND_TRANSFORM(pack_4, COEFFICIENTS_4);
#endif
#if PACKS > 5
    FILL_AND_TRANSFORM(pack_5, COEFFICIENTS_5);
#endif
}
