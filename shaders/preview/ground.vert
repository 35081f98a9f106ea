// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A vertex of the ground.
#include "preview/land_vertex.glsl"

out vec2 label;
out vec3 position;
out float line_share;  // of the lines' colour in the picture

// Slopes that the map lacks: their place in the node, 0 .. 1, the share of the next level in the
// vertex; their layer or -1, texels a metre.
out vec3 detail_place;
flat out vec2 detail_layer;

void main() {
    LandVertex vertex = land_vertex();
    label = vertex.shown;
    position = vec3(label, vertex.height - drop_at(label));
    line_share = share_of_lines();
    vec2 node_corner = vec2(place.xy) * lattice.z - lattice.xy;
    float along = 1.0 / (vertex.spacing * float(vertices_along - 1));
    detail_place = vec3((label - node_corner) * along, vertex.share);
    detail_layer = vec2(float(slopes_layer), 4.0 / vertex.spacing);
    gl_Position = on_screen(position);
}
