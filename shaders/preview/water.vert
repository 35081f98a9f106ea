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
#if COAST
out float gl_ClipDistance[1];
#endif

vec3 surface_point(vec2 at, float spacing) {
#if COAST
    CoastReads reads = coast_reads(at);
    vec3 point = shown_point(at, coast_shape(reads));
    if (reads.whole >= 1.0) return point;
    vec3 open = shown_point(at, displacement_at(copies_at(at), at, spacing));
    return mix(open, point, reads.whole);
#else
    return shown_point(at, displacement_at(copies_at(at), at, spacing));
#endif
}

void main() {
    MeshVertex vertex = morphed_vertex();
    label = vertex.label;
    position = surface_point(label, vertex.spacing);
#if COAST
    // The water ends where its mesh meets that of the bed.
    CoastReads reads = coast_reads(label);
    gl_ClipDistance[0] = mix(1.0, coast_shape(reads).w, reads.whole);
#endif
    line_share = share_of_lines(vertex);
    gl_Position = on_screen(position);
}
