// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A vertex of the ground.
#include "preview/land_vertex.glsl"

out vec2 label;
out vec3 position;
out float line_share;  // of the lines' colour in the picture

void main() {
    LandVertex vertex = land_vertex();
    label = vertex.shown;
    position = vec3(label, vertex.height - drop_at(label));
    line_share = share_of_lines(position, vertex.spacing);
    gl_Position = on_screen(position);
}
