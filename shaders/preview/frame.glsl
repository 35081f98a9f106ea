// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// What holds for a whole picture; libocean/preview/frame_block.hpp is its twin. Labels and
// positions are relative to the eye's place on the still water, x east, y north, z up, in metres.

layout(std140) uniform Frame {
    mat4 clip_from_world;
    mat4 world_from_clip;
    vec4 eye;         // 0, 0, height over still water; radius of the Earth
    vec4 sun;         // direction to it; how much of its disc is above the horizon
    vec4 sun_colour;  // what a white surface that faces it sends; cosine of the disc's radius
    vec4 sky_low;     // at the horizon; sine of the horizon's dip
    vec4 sky_middle;
    vec4 sky_high;
    vec4 sky_shadow;  // of the Earth, on the side away from a low sun; its share
    vec4 sky_light;   // of the sky as a whole, on a level white surface; how low the sun is, 0 .. 1
    vec4 water;       // albedo of the water body; index of refraction
    vec4 waves;       // choppiness, significant wave height, variance of slopes that no map has,
                      // number of cascades that have waves
    vec4 foam;        // threshold and width of whitecaps, albedo, amount
    vec4 patch_place; // place of the eye in the period of the sea, 0 .. 1; 1/period; mixing: 0, 1
    vec4 grid_place;  // place of the eye in its square of the grid of copies; a texel of the cover
    ivec4 grid_cell;  // that square
    vec4 look;        // exposure, distance of haze, angle of a pixel, seconds
    ivec4 view;       // what is shown
    vec4 range;       // of the values that a view shows: least, most
    vec4 cascade[5];  // place of the eye in its period, 0 .. 1; 1/period, metres of a texel
};
