// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The light of the ground, or a field of it as a view shows it.
#include "preview/ground_light.glsl"
#include "preview/tone.glsl"
#include "preview/two_sided.glsl"

in float line_share;
in vec3 detail_place;
flat in vec2 detail_layer;
uniform sampler2DArray detail_map;  // slope x, slope y, square of the slope; 4 texels of border
layout(location = 0) out vec4 colour;

vec3 normal_of(Ground ground) { return normalize(vec3(-ground.slope, 1.0)); }

// Returns the ground with the slopes of its patch, whose texels are finer than the map's. Where a
// patch changes to the next level it shows no finer ones than that.
Ground with_detail(Ground ground) {
    if (detail_layer.x < 0.0) return ground;
    Footprint footprint = footprint_of(label);
    float seen = max(footprint.width, 0.25 * length(footprint.longer));
    float mip = max(log2(max(seen * detail_layer.y, 1.0)), clamp(detail_place.z, 0.0, 1.0));
    float shown = clamp(4.0 - mip, 0.0, 1.0);
    float side = float(textureSize(detail_map, 0).x);
    vec2 at = (4.0 + detail_place.xy * (side - 8.0)) / side;
    vec3 fine = textureLod(detail_map, vec3(at, detail_layer.x), min(mip, 3.0)).xyz;
    float square = ground.steepness * ground.steepness;
    ground.slope = mix(ground.slope, fine.xy, shown);
    ground.steepness = sqrt(max(mix(square, fine.z, shown), 0.0));
    return ground;
}

// The cases are rows of libocean/preview/view_table.hpp. A number without a row is magenta.
vec4 shown_view(Ground ground) {
    switch (view.x) { VIEW_CASES }
    return vec4(1.0, 0.0, 1.0, 1.0);
}

void main() {
#if COAST
    colour = vec4(drawn_colour(shaded(ground_at(label))), 1.0);  // in every view of its water
#else
    colour = shown_view(with_detail(ground_at(label)));
#endif
    colour.a *= line_share;  // 1, unless only lines are drawn
}
