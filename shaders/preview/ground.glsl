// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The ground at a place: one tile's map, which repeats.
#include "preview/land_block.glsl"
#include "preview/on_screen.glsl"

uniform sampler2D ground_map;  // height [m], slope x, slope y, square of the slope

// Returns the place in the map. A sample lies in the middle of its texel.
vec2 map_place(vec2 at) {
    return tile.xy + at * tile.z + vec2(0.5 * tile.w * tile.z);
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
            ivec2 sample_at = (eye_texel.xy + ivec2(cell) + ivec2(i, j)) & (eye_texel.z - 1);
            vec4 corner = texelFetch(ground_map, sample_at, 0);
            sum += height[i].x * height[j].y * corner.x +
                   tile.w * (slope[i].x * height[j].y * corner.y +
                             height[i].x * slope[j].y * corner.z);
        }
    }
    return sum;
}

// Returns the height [m] for vertices of a spacing [m]. Means of cells would lower distant ridges;
// so the spacing counts half.
float ground_height(vec2 at, float spacing) {
    float mip = log2(0.5 * spacing / tile.w);
    if (mip <= 0.0) return patch_height(at);
    float mean = textureLod(ground_map, map_place(at), mip).x;
    return mip >= 1.0 ? mean : mix(patch_height(at), mean, mip);
}

// Returns the point of the ground, relative to the eye's place at height 0 [m].
vec3 ground_point(vec2 at, float spacing) {
    return vec3(at, ground_height(at, spacing) - drop_at(at));
}
