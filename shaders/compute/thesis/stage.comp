// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// One stage of the transform along one axis, from one texture to the other. [Fluegge 2017]
#include "compute/complex.glsl"

layout(local_size_x = 16, local_size_y = 16) in;

layout(binding = 0, rgba32f) readonly restrict uniform image2D butterflies;
layout(binding = 1, rg32f) readonly restrict uniform image2D given;
layout(binding = 2, rg32f) writeonly restrict uniform image2D result;

layout(location = 0) uniform int stage;
layout(location = 1) uniform int vertical;

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    vec4 butterfly = imageLoad(butterflies, ivec2(stage, vertical == 1 ? at.y : at.x));
    ivec2 first = vertical == 1 ? ivec2(at.x, butterfly.z) : ivec2(butterfly.z, at.y);
    ivec2 second = vertical == 1 ? ivec2(at.x, butterfly.w) : ivec2(butterfly.w, at.y);
    precise vec2 sum =
        imageLoad(given, first).xy + product(butterfly.xy, imageLoad(given, second).xy);
    imageStore(result, at, vec4(sum, 0.0, 0.0));
}
