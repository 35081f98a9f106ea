// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A vertex of the water: a level of the clipmap, morphed into the next coarser one as it goes away
// from the eye, so that nothing jumps and nothing swims.
#include "preview/on_screen.glsl"
#include "preview/sea.glsl"

layout(location = 0) in vec2 grid;

uniform vec4 level;  // label of grid (0, 0) relative to the eye; side of a cell [m]
// Cells from the eye where it begins, 1/length in cells; shortest distance [m]; 1: only lines.
uniform vec4 morph;

out vec2 label;
out vec3 position;
out float line_share;  // of the lines' colour in the picture

// Returns a direction from the eye to a point of the surface, in pixels.
vec3 sight(vec2 at, float spacing) {
    vec3 point = shown_point(at, displacement_at(copies_at(at), at, spacing));
    return normalize(point - vec3(0.0, 0.0, eye.z)) / look.z;
}

// Returns the share of a cell's lines: 1 where they lie four pixels apart, 0 at two pixels, where
// they would fill the picture. The lines of a cell follow two sides and their diagonal; they are
// closest to each other across the longest of the three.
float share_of_lines(vec2 at, float spacing) {
    vec3 here = sight(at, spacing);
    vec3 a = sight(at + vec2(spacing, 0.0), spacing) - here;
    vec3 b = sight(at + vec2(0.0, spacing), spacing) - here;
    float longest = sqrt(max(dot(a + b, a + b), max(dot(a, a), dot(b, b))));
    float apart = length(cross(a, b)) / max(longest, 1e-6);
    return smoothstep(2.0, 4.0, apart);
}

void main() {
    vec2 unmorphed = level.xy + grid * level.z;
    float distance = max(max(abs(unmorphed.x), abs(unmorphed.y)), morph.z);
    float share = clamp((distance / level.z - morph.x) * morph.y, 0.0, 1.0);
    label = unmorphed - mod(grid, 2.0) * share * level.z;
    float spacing = level.z * exp2(share);
    vec4 displacement = displacement_at(copies_at(label), label, spacing);
    position = shown_point(label, displacement);
    line_share = morph.w > 0.0 ? share_of_lines(label, spacing) : 1.0;
    gl_Position = on_screen(position);
}
