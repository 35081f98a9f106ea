// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Pass one of a frame: from the modes to their state at one time, from that to the coefficients of
// pairs of fields, and the transform along x. A workgroup has one row of ky.
// Defined outside: N, COLUMNS, PACKS, and COEFFICIENTS_p of each pack, made of the table of linear
// fields: complex numbers of the variables h, h_rate, kx, ky and u below.
#define LINES 1
#include "wave/turns.glsl"
#include "wave/phase.glsl"
#include "compute/complex.glsl"
#include "compute/modes.glsl"
#include "compute/line_transform.glsl"
#include "compute/packs.glsl"

layout(local_size_x = THREADS) in;

layout(location = 3) uniform float gradient_scale;  // a power of two

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
    float ky = wavenumber(y);
    vec2 state[8];
    vec2 state_rate[8];
    float u_of[8];
    for (uint e = 0u; e < 8u; ++e) {
        uint x = thread + e * THREADS;
        ModeState mode = mode_at(x, y);
        state[e] = vec2(mode.re, mode.im);
        state_rate[e] = vec2(mode.rate_re, mode.rate_im);
        u_of[e] = displacement[y * N + x];
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
