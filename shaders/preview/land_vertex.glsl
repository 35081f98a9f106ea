// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A vertex of a patch of land, by the arithmetic of land_vertex() in
// ocean/internal/land_quadtree.hpp, which says why the patches meet without cracks. A label is an
// integer number of spacings of level 0 from the snapped eye, less the eye's own place: all levels
// give it the same bits.
#include "preview/land_block.glsl"
#include "preview/on_screen.glsl"

layout(location = 0) in ivec2 grid;    // of a quarter of a node
layout(location = 1) in ivec4 place;   // corner of the node, in level 0; level; row of its heights
layout(location = 2) in ivec2 corner;  // of the quarter in the node
layout(location = 3) in int slopes_layer;

const int vertices_along = 17;  // a node

uniform sampler2D patch_heights;  // a row for each node: own height, that of the coarser mesh [m]

struct LandVertex {
    vec2 shown;     // relative to the eye [m]
    float height;   // [m]
    float spacing;  // [m]
    float share;    // of the next level's mesh
};

vec2 label_at(ivec2 vertex) {
    ivec2 units = place.xy + vertex * (1 << place.z);
    return clamp(vec2(units) * lattice.z - lattice.xy, edge.xy, edge.zw);
}

vec2 heights_at(ivec2 vertex) {
    return texelFetch(patch_heights, ivec2(vertex.y * vertices_along + vertex.x, place.w), 0).xy;
}

LandVertex land_vertex() {
    ivec2 vertex = corner + grid;
    ivec2 odd = vertex & 1;
    ivec2 first = vertex - odd, last = vertex + odd;  // the parent's edge that it halves
    vec2 shown = label_at(vertex);
    float spacing = lattice.z * float(1 << place.z);
    float squared = (dot(shown, shown) + lattice.w) / (spacing * spacing);
    bool coarsest = place.z >= int(morphing.w);
    if (!coarsest && sqrt(squared) >= morphing.z) {
        ivec2 end = odd.x * odd.y == 1 ? first : last;
        return LandVertex(label_at(end), heights_at(end).y, spacing, 1.0);
    }
    float share = coarsest ? 0.0 : clamp((squared - morphing.x) * morphing.y, 0.0, 1.0);
    vec2 both = heights_at(vertex);
    if (share == 0.0) return LandVertex(shown, both.x, spacing, 0.0);
    if (edge.z < 1e29) shown += share * (0.5 * (label_at(first) + label_at(last)) - shown);
    return LandVertex(shown, share == 1.0 ? both.y : both.x + share * (both.y - both.x), spacing,
                      share);
}

// Returns a direction from the eye to a vertex of the patch, in pixels.
vec3 sight_of(ivec2 vertex) {
    vec2 at = label_at(vertex);
    vec3 point = vec3(at, heights_at(vertex).x - drop_at(at) - eye.z);
    return normalize(point) / look.z;
}

// Returns the share of a quad's lines in the picture, as clipmap.glsl: 1 for surfaces and where the
// lines lie three pixels apart, 0 at one.
float share_of_lines() {
    if (colours.y == 0) return 1.0;
    ivec2 vertex = corner + grid;
    ivec2 step_to = 1 - 2 * ivec2(equal(vertex, ivec2(vertices_along - 1)));
    vec3 here = sight_of(vertex);
    vec3 a = sight_of(vertex + ivec2(step_to.x, 0)) - here;
    vec3 b = sight_of(vertex + ivec2(0, step_to.y)) - here;
    float longest = sqrt(max(dot(a + b, a + b), max(dot(a, a), dot(b, b))));
    float apart = length(cross(a, b)) / max(longest, 1e-6);
    return smoothstep(1.2, 3.0, apart);
}
