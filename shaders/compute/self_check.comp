// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// One mode's phase, noise and coefficients a thread, for the library to compare with its own: whether
// this driver computes as the shaders need it.
// Defined outside: PAIR_0 .. PAIR_5, the coefficients of pairs of fields as pass one has them.
#include "wave/turns.glsl"
#include "wave/noise.glsl"
#include "wave/phase.glsl"
#include "compute/complex.glsl"

layout(local_size_x = 64) in;

layout(std430, binding = 0) readonly restrict buffer Given {
    vec4 given[];  // rate and tau, high and low
};
layout(std430, binding = 1) writeonly restrict buffer Result {
    vec4 result[];  // turns, sine, and the two numbers of noise
};
layout(std430, binding = 2) writeonly restrict buffer Coefficients {
    vec2 coefficient[];  // six a mode
};

layout(location = 0) uniform float gradient_scale;

void main() {
    uint i = gl_GlobalInvocationID.x;
    float turns = phase_turns(given[i].x, given[i].y, given[i].z, given[i].w);
    Gaussian xi = gaussian_noise(i + 1u, i % 5u, int(i) - 7, 3 - int(i));
    result[i] = vec4(turns, sin_cos_turns(turns).sine, xi.re, xi.im);
    vec2 h = vec2(xi.re, xi.im);
    vec2 h_rate = vec2(xi.im, -2.0 * xi.re);
    float kx = float(int(i % 16u) - 7);
    float ky = float(int(i / 16u) - 5);
    float u = 0.25 + float(i % 3u);
    precise vec2 pair_0 = PAIR_0;
    precise vec2 pair_1 = PAIR_1;
    precise vec2 pair_2 = PAIR_2;
    precise vec2 pair_3 = PAIR_3;
    precise vec2 pair_4 = PAIR_4;
    precise vec2 pair_5 = PAIR_5;
    coefficient[6u * i] = pair_0;
    coefficient[6u * i + 1u] = pair_1;
    coefficient[6u * i + 2u] = pair_2;
    coefficient[6u * i + 3u] = pair_3;
    coefficient[6u * i + 4u] = pair_4;
    coefficient[6u * i + 5u] = pair_5;
}
