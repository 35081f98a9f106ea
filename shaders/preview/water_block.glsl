// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The values of the water in one picture; libocean/preview/water_block.hpp is its twin. Labels are
// relative to the eye's place on the still water [m].

layout(std140) uniform WaterBlock {
    vec4 waves;       // choppiness, significant wave height [m], mean square slope (0: of the maps)
    vec4 foam;        // threshold and width of whitecaps, unused, amount
    vec4 crest;       // colour of crests with the sun behind them; amount
    vec4 range;       // lowest and highest value that a view shows
    vec4 period;      // 1/period of the sea [1/m]; 1 if copies hide its repetition, else 0
    vec4 grid_place;  // place of the eye in its square of the grid of copies
    ivec4 grid_cell;  // that square
    vec4 cascade[10];  // place of the eye, in periods; 1/period [1/m], side of a texel [m]
    vec4 part[10];     // weight, its periods in that of its sea, layer of its maps
    vec4 cover[2];     // place of the eye in a map of foam, 0 .. 1; 1/period [1/m], 1/resolution
    vec4 cover_share;  // share of each map of foam
    // The pattern of each foam: direction of its cells over a tile [1/m], 1/stretch, share of the
    // streaks; places of the eye in the large net and the net; in the bubbles and the streaks.
    vec4 lace[2];
    vec4 lace_net[2];
    vec4 lace_more[2];
    // The slope tiles: place of the eye in its tile, 0 .. 1, 1/tile [1/m], weight; place of the eye
    // in its square of the grid, shortest and longest wave [m]; that square, layer and samples a
    // side of its map; variance of the slopes xx, yy, xy; shares of it that reads of eight levels
    // of mipmaps have.
    vec4 tile[6];
    vec4 tile_grid[6];
    ivec4 tile_cell[6];
    vec4 tile_variance[6];
    vec4 tile_read[12];
};
