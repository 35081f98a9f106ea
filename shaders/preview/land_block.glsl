// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The values of a land in one picture; libocean/preview/land_block.hpp is its twin. Places are
// relative to the eye's place at height 0 [m].

layout(std140) uniform LandBlock {
    vec4 tile;      // place of the eye in its tile, 0 .. 1; 1/period [1/m], side of a texel [m]
    vec4 texel;     // place of the eye in its texel, 0 .. 1
    ivec4 eye_texel;  // that texel; samples of the map along a side
    vec4 heights;   // mean, rms about it, lowest, highest [m]
    vec4 range;     // lowest and highest value that a view shows; cell of the terrain's grid [m]
    vec4 snow;      // height of the snow line, half the width of its belt, its rise for a slope of
                    // 1 that faces the sun, its rise for wear of 1 [m]
    vec4 shadow;    // steps towards the sun; distance of the last one [m]
    ivec4 colours;  // 0: of land, 1: the ramp of the teaching programs
    // The cover noise: place of the eye in its cell, 0 .. 1, 1/cell [1/m], cell [m]; that cell.
    vec4 cover[4];
    ivec4 cover_cell[4];
};
