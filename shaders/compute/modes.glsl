// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The modes of a map, as the library uploads them, and their state at one time. Needs turns.glsl
// and phase.glsl. Defined outside: N.

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

float wavenumber(uint index) {
    return wavenumber_step * float(int(index) - (index < N / 2u ? 0 : N));
}

ModeState mode_at(uint x, uint y) {
    uint at = y * N + x;
    vec2 own = h0[at];
    vec2 mirror = h0[((N - y) & (N - 1u)) * N + ((N - x) & (N - 1u))];
    vec2 turn_rate = rate[at];
    float turns = phase_turns(turn_rate.x, turn_rate.y, tau.x, tau.y);
    return mode_state(own.x, own.y, mirror.x, mirror.y, turns, turn_rate.x * rate_factor);
}
