// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The sea at a label: sums over the maps of the cascades, each wrapped round its own period; far
// away, over copies of the sea too. Waves too fine for the requested footprint are left to the
// mipmaps, and their variance to the light.
//
// A sea has one array of maps, a layer for each cascade. Two seas that are faded into each other
// have two (MAPS): the cascades before SPLIT lie in the first one, those up to CASCADES in the
// second.
#include "preview/on_screen.glsl"
#include "preview/water_block.glsl"
#include "wave/copies.glsl"

uniform sampler2DArray shape_maps[MAPS];         // Dx, Dy, height, dDx/dy, for vertices
uniform sampler2DArray displacement_maps[MAPS];  // the same for fragments
uniform sampler2DArray gradient_maps[MAPS];      // slope x, slope y, dDx/dx, dDy/dy
uniform sampler2DArray moment_maps[MAPS];        // squares of the slopes, their product, squeezing
uniform sampler2D cover_map[COVERS];             // of foam, of a sea's whole period

// The copies of the sea that are shown at a label: the offset of each from the label, in periods,
// and its weight. Nearer than a period the sea itself is shown alone.
struct Copies {
    int count;
    vec2 offset[4];
    float weight[4];
};

Copies copies_at(vec2 label) {
    Copies copies;
    copies.count = 1;
    copies.offset[0] = vec2(0.0);
    copies.weight[0] = 1.0;
    vec2 place = label * period.x;
    float share = period.y * smoothstep(1.0, 2.0, length(place));
    if (share <= 0.0) return copies;

    GridPoint skewed = copy_grid(place.x, place.y);
    vec2 at = grid_place.xy + vec2(skewed.x, skewed.y);
    vec2 cell = floor(at);
    vec2 inside = at - cell;
    copies.count = 4;
    copies.weight[0] = 1.0 - share;
    float squares = copies.weight[0] * copies.weight[0];
    for (int i = 0; i < 3; ++i) {
        CopyCorner corner = copy_corner(inside.x, inside.y, i);
        ivec2 square = grid_cell.xy + ivec2(cell) + ivec2(corner.x, corner.y);
        GridPoint moved = copy_offset(square.x, square.y);
        copies.offset[i + 1] = vec2(moved.x, moved.y);
        copies.weight[i + 1] = share * corner.weight;
        squares += copies.weight[i + 1] * copies.weight[i + 1];
    }
    float scale = inversesqrt(squares);
    for (int i = 0; i < 4; ++i) copies.weight[i] *= scale;
    return copies;
}

// Returns the place in the map of a cascade. A sample lies in the middle of its texel. An offset of
// a copy in periods of the sea is part[c].y times as many periods of the cascade.
vec2 map_place(int c, vec2 label, vec2 offset) {
    vec2 moved = fract(offset * part[c].y);
    return cascade[c].xy + label * cascade[c].z + moved + 0.5 * cascade[c].w * cascade[c].z;
}

// Adds the cascades from `first` up to `end`, which lie in one array, with the waves that a spacing
// [m] can hold.
void add_cascades(inout vec4 sum, sampler2DArray maps, int first, int end, Copies copies,
                  vec2 label, float spacing) {
    for (int c = first; c < end; ++c) {
        float mip = max(0.0, log2(spacing / cascade[c].w));
        if (spacing * cascade[c].z >= 1.0) continue;  // a period is less than the spacing
        for (int i = 0; i < copies.count; ++i) {
            vec2 place = map_place(c, label, copies.offset[i]);
            sum += part[c].x * copies.weight[i] * textureLod(maps, vec3(place, part[c].z), mip);
        }
    }
}

vec4 sum_at(sampler2DArray maps[MAPS], Copies copies, vec2 label, float spacing) {
    vec4 sum = vec4(0.0);
    add_cascades(sum, maps[0], 0, SPLIT, copies, label, spacing);
#if MAPS > 1
    add_cascades(sum, maps[1], SPLIT, CASCADES, copies, label, spacing);
#endif
    return sum;
}

// Returns Dx, Dy at choppiness 1, height [m], and dDx/dy.
vec4 displacement_at(Copies copies, vec2 label, float spacing) {
    return sum_at(shape_maps, copies, label, spacing);
}

// Returns the point of a label, relative to the eye's place on the still water [m].
vec3 shown_point(vec2 label, vec4 displacement) {
    return vec3(label - waves.x * displacement.xy, displacement.z - drop_at(label));
}
