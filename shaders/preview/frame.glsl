// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The values of a whole picture, for every drawable: camera, sky, air and the water body.
// libocean/preview/frame_block.hpp is its twin. Positions are relative to the eye's place on the
// still water, x east, y north, z up [m].

layout(std140) uniform FrameBlock {
    mat4 clip_from_world;  // of positions relative to the eye itself
    mat4 world_from_clip;
    vec4 eye;         // 0, 0, height over still water [m]; 1 on the round Earth, 0 on a flat one
    vec4 depth;       // 1/log2(1 + distance of the far end [m]), or 0: depth by clip_from_world
    vec4 look;        // exposure, visibility [m] or 0, angle of a pixel [rad]; 1: draw linear light
    ivec4 view;       // number of the view, see libocean/preview/view_table.hpp; 1: of a sea, whose
                      // water fills all below height 0, 0: of land
    vec4 sun;         // direction to it; share of its disc above the horizon
    vec4 sun_colour;  // radiance of a white surface that faces it
    vec4 sky_low;     // at the horizon; sine of the horizon's dip
    vec4 sky_middle;  // w: 1 if a map is the sky, else 0
    vec4 sky_high;    // w: turn of that map, 0 .. 1
    vec4 sky_shadow;  // of the Earth, on the side away from a low sun; its share
    vec4 sky_light;   // of the whole sky, on a level white surface
    vec4 water;       // albedo of the water body; index of refraction
    vec4 loss;        // loss of contrast in the water body [1/m]
};
