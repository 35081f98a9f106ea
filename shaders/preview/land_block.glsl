// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The values of a land in one picture; libocean/preview/land_block.hpp is its twin. Places are
// relative to the eye's place at height 0 [m].

layout(std140) uniform LandBlock {
    vec4 tile;      // place of the eye in the map, 0 .. 1 where it repeats; 1/its side [1/m], side
                    // of a texel [m]
    vec4 texel;     // place of the eye in its texel, 0 .. 1
    ivec4 eye_texel;  // that texel; samples of the map along a side; 1: the map repeats
    vec4 heights;   // mean, relief that the covers follow, lowest, highest [m]
    vec4 range;     // lowest and highest value that a view shows; cell of the terrain's grid [m]
    vec4 snow;      // height of the snow line, half the width of its belt, its rise for a slope of
                    // 1 that faces the sun, its rise for wear of 1 [m]
    vec4 shadow;    // steps towards the sun; distance of the last one [m]
    ivec4 colours;  // 0: of land, 1: the ramp of the teaching programs; 1: only lines are drawn
    // The lattice of vertices: the eye's place beside the snapped one, spacing of level 0 [m],
    // square of the eye's height over the plane of distances [m^2].
    vec4 lattice;
    // In spacings of a level: square of the distance where its morph begins, 1/(square where it
    // ends - that one), distance from which vertices are snapped; the coarsest level.
    vec4 morphing;
    vec4 edge;        // lowest and highest place of the land relative to the eye [m], 1e30 without
                      // end
    vec4 water_line;  // height of still water [m]; 1: there is some; the tree line [m]
    // The cover noise, of four sizes, and the grain of the relief, of five: place of the eye in its
    // cell, 0 .. 1, 1/cell [1/m], cell [m]; that cell.
    vec4 cover[9];
    ivec4 cover_cell[9];
};
