// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The butterfly texture of [Fluegge 2017]: for each stage (x) and each output (y) of a radix-2
// transform the root of unity and the two inputs it joins. Run once for a size.
layout(local_size_x = 1, local_size_y = 16) in;

layout(binding = 0, rgba32f) writeonly restrict uniform image2D butterflies;

layout(std430, binding = 3) readonly restrict buffer Roots {
    vec2 root[];  // e^(2 pi i k / N)
};

uint reversed(uint number) {
    return bitfieldReverse(number) >> (32 - STAGES);
}

void main() {
    uint stage = gl_GlobalInvocationID.x;
    uint y = gl_GlobalInvocationID.y;
    uint span = 1u << stage;
    uint turn = y * (uint(N) >> (stage + 1u)) & (uint(N) - 1u);
    bool top = (y & span) == 0u;
    uint first = top ? y : y - span;
    uint second = first + span;
    if (stage == 0u) {
        first = reversed(first);
        second = reversed(second);
    }
    imageStore(butterflies, ivec2(stage, y), vec4(root[turn], first, second));
}
