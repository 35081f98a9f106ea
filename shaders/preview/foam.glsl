// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Foam in a pixel: its share by the map of cover, and near the eye its pattern.
#include "preview/foam_look.glsl"
#include "preview/water_state.glsl"
#include "wave/foam_lace.glsl"

// Returns the share of the water that foam hides.
float cover_of(Water water) {
    float sum = 0.0;
    for (int v = 0; v < COVERS; ++v) sum += cover_share[v] * water.foam[v].r;
    return clamp(sum, 0.0, 1.0);
}

#if LACE
uniform sampler2D lace_map;
uniform sampler2D bubble_map;
uniform sampler2D streak_map;
uniform int lace_ready;  // 0: these textures are not made yet
uniform sampler2D lace_shares;  // eight rows for each: the share of a level's reads below a value

// Returns a read of a texture that is `tile` metres wide, uniform in [0, 1]: not the mean itself,
// but the share of its level's reads that are lower.
float uniform_read(sampler2D map, int rows, vec2 place, float footprint, float tile) {
    float texels = footprint / tile * float(textureSize(map, 0).x);
    float last = log2(float(textureSize(map, 0).x)) - 5.0;
    float level = min(floor(log2(max(texels, 1.0)) + 0.5), last);
    vec2 size = vec2(textureSize(lace_shares, 0));
    float read = textureLod(map, place, level).r;
    vec2 row = vec2(read * (size.x - 1.0) + 0.5, float(rows) + level + 0.5);
    return textureLod(lace_shares, row / size, 0.0).r;
}

// Returns a read of the streaks at a label.
float streaks_at(int v, vec2 at, float footprint) {
    vec2 tiles = vec2(dot(at, lace[v].xy), at.y * lace[v].x - at.x * lace[v].y);
    vec2 place = lace_more[v].zw + tiles * (lace_tile / streak_tile);
    return uniform_read(streak_map, 16, place, footprint, streak_tile);
}

// Returns the value that draws the foam of a cover at a label, uniform in [0, 1], as POV-Ray's
// Ocean_Lace_ does; net_alone: the value of the net without bubbles and streaks.
float lace_at(int v, vec2 at, float footprint, out float net_alone) {
    vec2 tiles = vec2(dot(at, lace[v].xy), at.y * lace[v].x - at.x * lace[v].y);
    vec2 net = vec2(tiles.x * lace[v].z, tiles.y);
    vec2 turned = vec2(3.0 * net.x + net.y, 3.0 * net.y - net.x) / 11.0;
    net_alone = unite_uniform(
        uniform_read(lace_map, 0, lace_net[v].xy + turned, footprint,
                     lace_tile * 11.0 / sqrt(10.0)),
        uniform_read(lace_map, 0, lace_net[v].zw + net, footprint, lace_tile), 0.08);
    float bubbled = max(0.3 - 0.3 * foam_fade(footprint, bubble_cell), 1e-3);
    float bubbles = uniform_read(bubble_map, 8, lace_more[v].xy + tiles * (lace_tile / bubble_tile),
                                 footprint, bubble_tile);
    float value = add_uniform(net_alone, bubbles, bubbled);
    if (lace[v].w <= 0.0) return value;
    return add_uniform(value, streaks_at(v, at, footprint), lace[v].w);
}
#endif

// The foam that a pixel shows.
struct Foam {
    float white;      // share of the pixel
    float thickness;  // of that share
    float height;     // over the water [m]
    float value;      // that draws it, 0 .. 1, of the last cover
    float plume;      // amount of bubbles below
};

Foam foam_at(Water water, vec2 at) {
    float footprint = water.footprint;
    Foam seen = Foam(0.0, 0.0, 0.0, 1.0, 0.0);
    float thick = 0.0;
    for (int v = 0; v < COVERS; ++v) {
        vec3 mean = water.foam[v];
        float c = clamp(foam.w * mean.r, 0.0, 1.0);
        float white = c;
        float thickness = mean.g / max(mean.r, 1e-6);
        float height = 0.0;
        float bubbles = clamp(foam.w, 0.0, 1.0) * mean.b;
#if LACE
        if (c > 0.0 && lace_ready > 0) {
            float far = foam_fade(footprint, lace_cell);
            float gathered = lace[v].w * (1.0 - foam_fade(footprint, streak_cell));
            if (gathered > 0.0) white = foam_in_streaks(c, streaks_at(v, at, footprint), gathered);
            float around = max(bubbles, white);
            if (far < 1.0) {
                float net;
                seen.value = lace_at(v, at, footprint, net);
                float edge = foam_pixel_edge(foam_edge, footprint, lace_cell);
                white = mix(foam_mask(c, seen.value, edge), white, far);
                float here = foam_thickness(c, seen.value, foam_span);
                thickness = foam_pixel_thickness(here, thickness, footprint, lace_cell);
                around = mix(foam_bubbles(bubbles, c, seen.value), around, far);
                // The slope follows from differences of pixels, and bubbles are smaller than two.
                height = foam_height * foam_thickness(c, net, 1.0) * (1.0 - far);
            }
            bubbles = around;
        }
#endif
        seen.white += cover_share[v] * white;
        thick += cover_share[v] * white * thickness;
        seen.height += cover_share[v] * height;
        seen.plume += cover_share[v] * bubbles;
    }
    seen.thickness = thick / max(seen.white, 1e-6);
    return seen;
}
