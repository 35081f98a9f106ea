// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A vertex of the water.
#include "preview/clipmap.glsl"
#include "preview/sea.glsl"
#if COAST
#include "preview/coast.glsl"
#endif

out vec2 label;
out vec3 position;
out float line_share;  // of the lines' colour in the picture

vec3 surface_point(vec2 at, float spacing) {
#if COAST
    CoastShape coast = coast_shape(at);
    vec3 point = shown_point(at, coast.shape);
    if (coast.share >= 1.0) return point;
    vec3 open = shown_point(at, displacement_at(copies_at(at), at, spacing));
    return mix(open, point, coast.share);
#else
    return shown_point(at, displacement_at(copies_at(at), at, spacing));
#endif
}

void main() {
    MeshVertex vertex = morphed_vertex();
    label = vertex.label;
    position = surface_point(label, vertex.spacing);
    line_share = share_of_lines(vertex);
    gl_Position = on_screen(position);
}
