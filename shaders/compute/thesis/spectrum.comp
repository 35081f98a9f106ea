// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The coefficients of one linear field at one time, with k = 0 in the middle, as [Fluegge 2017] has
// them. Defined outside: N, and COEFFICIENT, a complex number of h, h_rate, kx, ky and u.
#include "wave/turns.glsl"
#include "wave/phase.glsl"
#include "compute/complex.glsl"
#include "compute/modes.glsl"

layout(local_size_x = 16, local_size_y = 16) in;

layout(binding = 0, rg32f) writeonly restrict uniform image2D spectrum;

const float gradient_scale = 1.0;

void main() {
    ivec2 centred = ivec2(gl_GlobalInvocationID.xy);
    uint x = (uint(centred.x) + N / 2u) & (N - 1u);
    uint y = (uint(centred.y) + N / 2u) & (N - 1u);
    ModeState mode = mode_at(x, y);
    vec2 h = vec2(mode.re, mode.im);
    vec2 h_rate = vec2(mode.rate_re, mode.rate_im);
    float kx = wavenumber(x);
    float ky = wavenumber(y);
    float u = displacement[y * N + x];
    precise vec2 coefficient = COEFFICIENT;
    imageStore(spectrum, centred, vec4(coefficient, 0.0, 0.0));
}
