// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The surface of a coast at a label: of the finest window that holds it, blended into the next one
// and at last into the open sea where it ends.
#include "preview/coast_block.glsl"

uniform sampler2DArray coast_shapes;  // Dx, Dy, height, depth over the bed [m]

// Width in which the open sea takes over before the edge of the bed, where both are equal [m].
const float coast_border = 16.0;

vec2 window_place(int window, vec2 at) {
    return coast_window[window].xy + at * coast_window[window].z;
}

// Returns the share of a window at a place in its samples: it ends in an eighth of its side.
float window_share(int window, vec2 place) {
    float last = coast_window[window].w - 1.0;
    vec2 inside = min(place, last - place);
    return clamp((min(inside.x, inside.y) - 1.0) * 8.0 / last, 0.0, 1.0);
}

// Returns the share of all windows beside the open sea's.
float coast_share(vec2 at) {
    vec2 inside = min(at - coast_edge.xy, coast_edge.zw - at);
    return clamp(min(inside.x, inside.y) / coast_border, 0.0, 1.0);
}

// Returns the shape at a place of a window, linear between its samples with all bits of a float.
vec4 window_shape(int window, vec2 place) {
    vec2 cell = floor(place);
    vec2 t = place - cell;
    ivec3 first = ivec3(ivec2(cell), window);
    vec4 below = mix(texelFetch(coast_shapes, first, 0),
                     texelFetch(coast_shapes, first + ivec3(1, 0, 0), 0), t.x);
    vec4 above = mix(texelFetch(coast_shapes, first + ivec3(0, 1, 0), 0),
                     texelFetch(coast_shapes, first + ivec3(1, 1, 0), 0), t.x);
    return mix(below, above, t.y);
}

// The windows at a label: a window and the one outside it, into which it is blended.
struct CoastReads {
    int count;
    int window[2];
    vec2 place[2];   // in its samples
    float share[2];  // beside the open sea's
    float whole;     // their sum
};

CoastReads coast_reads(vec2 at) {
    CoastReads reads;
    reads.count = 0;
    reads.whole = 0.0;
    float left = coast_share(at);
    for (int i = 0; i < coast_count.x && left > 0.0 && reads.count < 2; ++i) {
        vec2 place = window_place(i, at);
        float share = left * window_share(i, place);
        if (share <= 0.0) continue;
        reads.window[reads.count] = i;
        reads.place[reads.count] = place;
        reads.share[reads.count++] = share;
        reads.whole += share;
        left -= share;
    }
    return reads;
}

// Returns the shape of the windows alone.
vec4 coast_shape(CoastReads reads) {
    vec4 shape = vec4(0.0);
    for (int i = 0; i < reads.count; ++i) {
        shape += reads.share[i] * window_shape(reads.window[i], reads.place[i]);
    }
    return reads.whole > 0.0 ? shape / reads.whole : shape;
}
