// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// From light to the colours of a screen: unchanged up to 0.6, rolled off towards 1 above, so that
// the sun's glitter shows waves too; then sRGB.
#include "preview/frame.glsl"

vec3 screen_colour(vec3 light) {
    vec3 x = max(look.x * light, vec3(0.0));
    vec3 above = max(x - 0.6, 0.0);
    vec3 rolled = min(x, 0.6) + 0.4 * above / (above + 0.4);
    return mix(12.92 * rolled, 1.055 * pow(max(rolled, vec3(1e-6)), vec3(1.0 / 2.4)) - 0.055,
               step(0.0031308, rolled));
}

// Returns the drawn colour of light: that of a screen, or the light itself for files of numbers.
vec3 drawn_colour(vec3 light) { return look.w > 0.0 ? look.x * light : screen_colour(light); }
