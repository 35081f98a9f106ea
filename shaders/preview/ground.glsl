// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The ground at a place, by the map of a tile, which repeats, or of land that exists once.
#include "preview/land_block.glsl"
#include "preview/on_screen.glsl"

uniform sampler2D ground_map;  // height [m], slope x, slope y, square of the slope
uniform sampler2D mask_map;    // 0.5 + (beach - cliff)/2, streambed, deposit, 0.5 + wear/2

// Returns the place in the map. A sample lies in the middle of its texel.
vec2 map_place(vec2 at) {
    return tile.xy + at * tile.z + vec2(0.5 * tile.w * tile.z);
}

// Returns the sample of the map so many texels from that of the eye.
ivec2 sample_of(ivec2 from_eye) {
    ivec2 at = eye_texel.xy + from_eye;
    int last = eye_texel.z - 1;
    return eye_texel.w == 1 ? at & last : clamp(at, ivec2(0), ivec2(last));
}

// Returns the height [m] of the bicubic Hermite patch with the heights and slopes of its corners,
// as LandImage::height_at.
float patch_height(vec2 at) {
    vec2 place = texel.xy + at / tile.w;
    vec2 cell = floor(place);
    vec2 t = place - cell;
    vec2 s = 1.0 - t;
    vec2 height[2] = vec2[2](s * s * (1.0 + 2.0 * t), t * t * (1.0 + 2.0 * s));
    vec2 slope[2] = vec2[2](t * s * s, -s * t * t);
    float sum = 0.0;
    for (int j = 0; j < 2; ++j) {
        for (int i = 0; i < 2; ++i) {
            vec4 corner = texelFetch(ground_map, sample_of(ivec2(cell) + ivec2(i, j)), 0);
            sum += height[i].x * height[j].y * corner.x +
                   tile.w * (slope[i].x * height[j].y * corner.y +
                             height[i].x * slope[j].y * corner.z);
        }
    }
    return sum;
}
