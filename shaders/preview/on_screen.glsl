// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Where a point is on the screen, and how deep: equal steps of depth for equal ratios of distance,
// from centimetres to the horizon. Behind the eye it is on the near plane, whose other side is
// never seen.
#include "preview/frame.glsl"

uniform float depth;  // 1/log2(1 + farthest); 0: as the projection says

// position: relative to the eye's place on the still water.
vec4 on_screen(vec3 position) {
    vec4 clip = clip_from_world * vec4(position - vec3(0.0, 0.0, eye.z), 1.0);
    if (depth > 0.0) clip.z = (2.0 * depth * log2(max(1.0, 1.0 + clip.w)) - 1.0) * clip.w;
    return clip;
}
