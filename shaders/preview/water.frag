// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The light of the water, or a field of it as a view shows it.
#include "wave/erfc.glsl"
#include "preview/water_at.glsl"
#include "preview/above_water.glsl"
#include "preview/tone.glsl"
#include "preview/two_sided.glsl"
#if BELOW
#include "preview/under_water.glsl"
#endif

in float line_share;
layout(location = 0) out vec4 colour;

// Returns the slope of a height, from its differences between pixels.
vec2 slope_of_height(float height, vec2 at) {
    vec2 rise = vec2(dFdx(height), dFdy(height));
    vec2 x = dFdx(at), y = dFdy(at);
    float area = x.x * y.y - x.y * y.x;
    if (abs(area) < 1e-12) return vec2(0.0);
    return vec2(rise.x * y.y - rise.y * x.y, rise.y * x.x - rise.x * y.x) / area;
}

vec4 shaded_view(Water state) {
    Foam froth = foam_at(state, label);
    vec2 slope = slope_of_height(froth.height, label);
    slope /= max(1.0, length(slope));
#if BELOW
    bool below = is_underside(cross(dFdx(position), dFdy(position)), from_eye_here());
    vec3 light = below ? shaded_from_below(state, froth) : shaded(state, froth, slope);
#else
    vec3 light = shaded(state, froth, slope);
#endif
    return vec4(drawn_colour(light), 1.0);
}

// Returns cover, white share of the pixel, thickness of the foam there, and the value that draws
// it.
vec4 foam_numbers(Water state) {
    Foam froth = foam_at(state, label);
    return vec4(cover_of(state), froth.white, froth.thickness, froth.value);
}

// The cases are rows of libocean/preview/view_table.hpp. A number without a row is magenta.
vec4 shown_view(Water state) {
    switch (view.x) { VIEW_CASES }
    return vec4(1.0, 0.0, 1.0, 1.0);
}

void main() {
    colour = shown_view(water_at(label));
    colour.a *= line_share;  // 1, unless only lines are drawn
}
