// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// One mode's phase and noise a thread, for the library to compare with its own: whether this driver
// computes as the shaders need it.
#include "wave/turns.glsl"
#include "wave/noise.glsl"
#include "wave/phase.glsl"

layout(local_size_x = 64) in;

layout(std430, binding = 0) readonly restrict buffer Given {
    vec4 given[];  // rate and tau, high and low
};
layout(std430, binding = 1) writeonly restrict buffer Result {
    vec4 result[];  // turns, sine, and the two numbers of noise
};

void main() {
    uint i = gl_GlobalInvocationID.x;
    float turns = phase_turns(given[i].x, given[i].y, given[i].z, given[i].w);
    Gaussian xi = gaussian_noise(i + 1u, i % 5u, int(i) - 7, 3 - int(i));
    result[i] = vec4(turns, sin_cos_turns(turns).sine, xi.re, xi.im);
}
