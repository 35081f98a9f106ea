// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The light of the ground, or a field of it as a view shows it.
#include "preview/ground_light.glsl"
#include "preview/tone.glsl"
#include "preview/two_sided.glsl"

in float line_share;
layout(location = 0) out vec4 colour;

vec3 normal_of(Ground ground) { return normalize(vec3(-ground.slope, 1.0)); }

// The cases are rows of libocean/preview/view_table.hpp. A number without a row is magenta.
vec4 shown_view(Ground ground) {
    switch (view.x) { VIEW_CASES }
    return vec4(1.0, 0.0, 1.0, 1.0);
}

void main() {
    colour = shown_view(ground_at(label));
    colour.a *= line_share;  // 1, unless only lines are drawn
}
