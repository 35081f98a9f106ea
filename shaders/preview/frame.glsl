// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// What holds for a whole picture; libocean/preview/frame_block.hpp is its twin. Labels and
// positions are relative to the eye's place on the still water, x east, y north, z up, in metres.

layout(std140) uniform Frame {
    mat4 clip_from_world;
    mat4 world_from_clip;
    vec4 eye;         // 0, 0, height over still water; 1, or 0 on a flat Earth
    vec4 sun;         // direction to it; how much of its disc is above the horizon
    vec4 sun_colour;  // what a white surface that faces it sends
    vec4 sky_low;     // at the horizon; sine of the horizon's dip
    vec4 sky_middle;  // whether a map is the sky: 0, 1
    vec4 sky_high;    // how far that is turned, 0 .. 1
    vec4 sky_shadow;  // of the Earth, on the side away from a low sun; its share
    vec4 sky_light;   // of the sky as a whole, on a level white surface
    vec4 water;       // albedo of the water body; index of refraction
    vec4 crest;       // colour of crests with the sun behind them; how much
    vec4 loss;        // what a metre of water takes of a sight: 1/m
    vec4 waves;       // choppiness, significant wave height, mean square slope (0: of the maps)
    vec4 foam;        // threshold and width of whitecaps, nothing, amount
    vec4 period;      // 1/period of the sea; whether copies hide its repetition: 0, 1
    vec4 grid_place;  // place of the eye in its square of the grid of copies
    ivec4 grid_cell;  // that square
    vec4 look;        // exposure, visibility [m] or 0, angle of a pixel; 1: drawn is light itself
    ivec4 view;       // what is shown
    vec4 range;       // of the values that a view shows: least, most
    vec4 cascade[10];  // place of the eye in its period, 0 .. 1; 1/period, metres of a texel
    vec4 part[10];     // how much of a cascade is shown; its periods in that of its sea
    vec4 cover[2];     // place of the eye in a map of foam, 0 .. 1; 1/period, 1/resolution
    vec4 cover_share;  // how much of each is shown
    // Of the pattern of each foam: direction of its cells over a tile [1/m], 1/stretch, share of
    // the streaks; places of the eye in the large net and the net; in the bubbles and the streaks.
    vec4 lace[2];
    vec4 lace_net[2];
    vec4 lace_more[2];
    // Of the slope tiles: place of the eye in its tile, 0 .. 1, 1/tile, how much is shown; place of
    // the eye in its square of the grid, shortest and longest wave; that square; variance of the
    // slopes xx, yy, xy; shares of it that reads of eight levels of mipmaps have.
    vec4 tile[6];
    vec4 tile_grid[6];
    ivec4 tile_cell[6];
    vec4 tile_variance[6];
    vec4 tile_read[12];
};
