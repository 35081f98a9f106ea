// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The place of a point on the screen and its depth, the same for every drawable of a picture: equal
// steps of depth for equal ratios of distance, from centimetres to the horizon.
#include "preview/frame.glsl"
#include "wave/horizon.glsl"

// Depth of a point at clip.w in front of the eye [m], 0 .. 1; points behind the eye have 0.
float depth_at(float distance) { return depth.x * log2(max(1.0, 1.0 + distance)); }

// Clip coordinates of a position relative to the eye's place on the still water [m]. The rasterizer
// interpolates depth linearly between vertices, which is right to e^2/8 of the distance where
// distances of a triangle's corners differ by a share e: 6e-5 for cells seen under 1/48. A drawable
// with larger triangles writes gl_FragDepth = depth_at(distance) from its fragment shader, with
// distance = 1/gl_FragCoord.w.
vec4 on_screen(vec3 position) {
    vec4 clip = clip_from_world * vec4(position - vec3(0.0, 0.0, eye.z), 1.0);
    if (depth.x > 0.0) clip.z = (2.0 * depth_at(clip.w) - 1.0) * clip.w;
    return clip;
}

// Returns how far still water at a place lies below the level at the eye's place [m].
float drop_at(vec2 place) { return eye.w * earth_drop(length(place)); }
