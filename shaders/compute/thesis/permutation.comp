// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The last pass: the real part, with the signs that a spectrum with its middle at k = 0 leaves
// behind taken back. The sum is not divided by N^2, as [Fluegge 2017] does: its amplitudes are ours.
layout(local_size_x = 16, local_size_y = 16) in;

layout(binding = 0, rg32f) readonly restrict uniform image2D given;
layout(binding = 1, r32f) writeonly restrict uniform image2D field;

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    float value = imageLoad(given, at).x;
    imageStore(field, at, vec4(((at.x + at.y) & 1) == 0 ? value : -value));
}
