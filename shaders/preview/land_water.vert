// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A vertex of the water of a land with a coast.
#include "preview/clipmap.glsl"
#include "preview/land_block.glsl"

out vec2 label;
out vec3 position;
out float line_share;

vec3 surface_point(vec2 at, float spacing) { return vec3(at, water_line.x - drop_at(at)); }

void main() {
    MeshVertex vertex = morphed_vertex();
    label = vertex.label;
    position = surface_point(label, vertex.spacing);
    line_share = share_of_lines(vertex);
    gl_Position = on_screen(position);
}
