// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A vertex of the ground.
#include "preview/clipmap.glsl"
#include "preview/ground.glsl"

out vec2 label;
out vec3 position;
out float line_share;  // of the lines' colour in the picture

vec3 surface_point(vec2 at, float spacing) { return ground_point(at, spacing); }

void main() {
    MeshVertex vertex = morphed_vertex();
    label = vertex.label;
    position = surface_point(label, vertex.spacing);
    line_share = share_of_lines(vertex);
    gl_Position = on_screen(position);
}
