// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A vertex of the bed of a coast, on the lattice of the water's vertices: the water ends where both
// have one height, without a gap.
#include "preview/clipmap.glsl"
#include "preview/coast.glsl"
#include "preview/ground.glsl"

out vec2 label;
out vec3 position;
out float line_share;
out vec3 detail_place;  // as of ground.vert: the bed has no slopes beside its map's
flat out vec2 detail_layer;

vec3 surface_point(vec2 at, float spacing) {
    CoastReads reads = coast_reads(at);
    vec4 shape = coast_shape(reads);
    float bed = textureLod(ground_map, map_place(at), 0.0).x;
    bed = mix(bed, shape.z - shape.w, reads.whole);
    return vec3(at, bed - drop_at(at));
}

void main() {
    MeshVertex vertex = morphed_vertex();
    label = vertex.label;
    position = surface_point(label, vertex.spacing);
    line_share = share_of_lines(vertex);
    detail_place = vec3(0.0);
    detail_layer = vec2(-1.0, 0.0);
    gl_Position = on_screen(position);
}
