// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Second moments of a cascade's gradients, texel by texel, for mipmaps to be made of.
layout(local_size_x = 16, local_size_y = 16) in;

layout(binding = 0, rgba32f) readonly restrict uniform image2D gradients;
layout(binding = 1, rgba32f) writeonly restrict uniform image2D moments;

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    vec4 gradient = imageLoad(gradients, at);
    float squeezed = gradient.z + gradient.w;
    imageStore(moments, at, vec4(gradient.x * gradient.x, gradient.y * gradient.y,
                                 gradient.x * gradient.y, squeezed * squeezed));
}
