// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Channels of one texel by the formulas of wave/surface.glsl and wave/foam_cover.glsl, which must
// be included before. Each function is named after its row in the table of channels; the rows
// without a formula are multiples.

layout(location = 0) uniform float choppiness;
layout(location = 1) uniform vec2 whitecap_threshold_and_width;
layout(location = 2) uniform vec2 foam_fade_and_cutoff;
layout(location = 4) uniform float foam_alone;

// The linear fields, by their names in the library; those that were not requested are 0.
struct Fields {
    float height;
    float displacement_x;
    float displacement_y;
    float slope_x;
    float slope_y;
    float gradient_xx;
    float gradient_yy;
    float gradient_xy;
    float height_rate;
    float displacement_x_rate;
    float displacement_y_rate;
};

vec3 normal_of(Fields p) {
    SurfaceNormal n = surface_normal(choppiness, p.gradient_xx, p.gradient_yy, p.gradient_xy,
                                     p.slope_x, p.slope_y);
    // z is near 1, so most of its digits are common to all samples: it is computed from the small
    // difference, not by inversesqrt, of which drivers promise little.
    float up = 1.0 - (n.x * n.x + n.y * n.y) / (1.0 + abs(n.z));
    return vec3(n.x, n.y, n.z < 0.0 ? -up : up);
}

float channel_nx(Fields p, float previous_foam) {
    return normal_of(p).x;
}

float channel_ny(Fields p, float previous_foam) {
    return normal_of(p).y;
}

float channel_nz(Fields p, float previous_foam) {
    return normal_of(p).z;
}

float channel_jacobian(Fields p, float previous_foam) {
    return surface_jacobian(choppiness, p.gradient_xx, p.gradient_yy, p.gradient_xy);
}

float channel_whitecap(Fields p, float previous_foam) {
    return surface_whitecap(channel_jacobian(p, previous_foam), whitecap_threshold_and_width.x,
                            whitecap_threshold_and_width.y);
}

float channel_foam(Fields p, float previous_foam) {
    float foam = foam_with_whitecap(channel_whitecap(p, previous_foam),
                                    foam_fade_and_cutoff.x * previous_foam, foam_alone);
    return foam < foam_fade_and_cutoff.y ? 0.0 : foam;
}
