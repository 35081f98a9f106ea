// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A vertex of the water: a level of the clipmap, morphed into the next coarser one as it goes away
// from the eye, so that nothing jumps and nothing swims.
#include "preview/on_screen.glsl"
#include "preview/sea.glsl"

layout(location = 0) in vec2 grid;

uniform vec4 level;  // label of grid (0, 0) relative to the eye; side of a cell [m]
uniform vec4 morph;  // cells from the eye where it begins, 1/length in cells; shortest distance [m]

out vec2 label;
out vec3 position;

void main() {
    vec2 unmorphed = level.xy + grid * level.z;
    float distance = max(max(abs(unmorphed.x), abs(unmorphed.y)), morph.z);
    float share = clamp((distance / level.z - morph.x) * morph.y, 0.0, 1.0);
    label = unmorphed - mod(grid, 2.0) * share * level.z;
    float spacing = level.z * exp2(share);
    vec4 displacement = displacement_at(copies_at(label), label, spacing);
    position = shown_point(label, displacement);
    gl_Position = on_screen(position);
}
