// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A vertex of the look `seed`: TILES x TILES equal periods beside each other on a flat Earth, as
// the teaching programs drew the sea.
#include "preview/on_screen.glsl"
#include "preview/sea.glsl"
#include "wave/surface.glsl"

layout(location = 0) in vec2 grid;  // 0 .. 1 across a tile

// Label of the first tile's corner relative to the eye; sides of a tile and of a cell [m].
uniform vec4 tiles;

out vec3 position;
out vec3 normal;

void main() {
    vec2 label = tiles.xy + (vec2(gl_InstanceID % TILES, gl_InstanceID / TILES) + grid) * tiles.z;
    Copies one = copies_at(label);
    vec4 displacement = displacement_at(one, label, tiles.w);
    vec4 gradients = sum_at(gradient_maps, one, label, tiles.w);
    position = shown_point(label, displacement);
    SurfaceNormal up = surface_normal(waves.x, gradients.z, gradients.w, displacement.w,
                                      gradients.x, gradients.y);
    normal = vec3(up.x, up.y, up.z);
    gl_Position = on_screen(position);
}
