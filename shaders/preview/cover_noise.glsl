// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Noise that breaks up the edges of snow, rock and woods: values at the corners of a square grid
// with cubic blends between them, of four cell sizes, because one size alone looks like the spots
// of a leopard. It lies in the world and not in the tile, so that it does not repeat with the land.
#include "preview/land_block.glsl"
#include "wave/copies.glsl"

// Returns -1 .. 1 for a place relative to the eye, by one size of cells.
float cover_noise_of(int size, vec2 at) {
    vec2 place = cover[size].xy + at * cover[size].z;
    vec2 cell = floor(place);
    vec2 t = place - cell;
    t = t * t * (3.0 - 2.0 * t);
    ivec2 corner = cover_cell[size].xy + ivec2(cell);
    float value[4];
    for (int i = 0; i < 4; ++i) {
        GridPoint hashed = copy_offset(corner.x + (i & 1), corner.y + (i >> 1) + 7919 * size);
        value[i] = 2.0 * hashed.x - 1.0;
    }
    return mix(mix(value[0], value[1], t.x), mix(value[2], value[3], t.x), t.y);
}

// Returns the sum of all sizes, about -1 .. 1, without the cells that a footprint [m] holds.
float cover_noise(vec2 at, float footprint) {
    const float weight[4] = float[4](0.45, 0.5, 0.4, 0.35);  // from the largest cells
    float sum = 0.0;
    for (int size = 0; size < 4; ++size) {
        float shown = 1.0 - smoothstep(0.3, 1.0, footprint * cover[size].z);
        if (shown > 0.0) sum += shown * weight[size] * cover_noise_of(size, at);
    }
    return sum;
}
