// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A vertex of the clipmap: of a level that is morphed into the next coarser one as it goes away
// from the eye, so that nothing jumps and nothing swims. The shader defines surface_point().
#include "preview/on_screen.glsl"

layout(location = 0) in vec2 grid;

uniform vec4 level;  // label of grid (0, 0) relative to the eye; side of a cell [m]
// Cells from the eye where it begins, 1/length in cells; shortest distance [m]; 1: only lines.
uniform vec4 morph;

// Returns the point of a label, relative to the eye's place on the still water [m], with the waves
// that a spacing [m] can hold.
vec3 surface_point(vec2 at, float spacing);

struct MeshVertex {
    vec2 label;
    float spacing;  // [m]
};

MeshVertex morphed_vertex() {
    vec2 unmorphed = level.xy + grid * level.z;
    float distance = max(max(abs(unmorphed.x), abs(unmorphed.y)), morph.z);
    float share = clamp((distance / level.z - morph.x) * morph.y, 0.0, 1.0);
    return MeshVertex(unmorphed - mod(grid, 2.0) * share * level.z, level.z * exp2(share));
}

// Returns a direction from the eye to a point of the surface, in pixels.
vec3 sight(vec2 at, float spacing) {
    return normalize(surface_point(at, spacing) - vec3(0.0, 0.0, eye.z)) / look.z;
}

// Returns the share of a cell's lines in the picture: 1 for surfaces and where the lines lie four
// pixels apart, 0 at two pixels, where they would fill it. The lines of a cell follow two sides and
// their diagonal; they are closest to each other across the longest of the three.
float share_of_lines(MeshVertex vertex) {
    if (morph.w <= 0.0) return 1.0;
    vec3 here = sight(vertex.label, vertex.spacing);
    vec3 a = sight(vertex.label + vec2(vertex.spacing, 0.0), vertex.spacing) - here;
    vec3 b = sight(vertex.label + vec2(0.0, vertex.spacing), vertex.spacing) - here;
    float longest = sqrt(max(dot(a + b, a + b), max(dot(a, a), dot(b, b))));
    float apart = length(cross(a, b)) / max(longest, 1e-6);
    return smoothstep(2.0, 4.0, apart);
}
