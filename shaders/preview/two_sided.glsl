// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Colours of the values in the range that a view shows. Include it after the block with `range`.

float range_width() { return max(range.y - range.x, 1e-9); }

// Returns the colour of a value in the shown range: white in the middle, blue below, red above.
vec4 two_sided(float value) {
    float x = clamp(2.0 * (value - range.x) / range_width() - 1.0, -1.0, 1.0);
    vec3 low = vec3(0.11, 0.30, 0.62);
    vec3 high = vec3(0.66, 0.13, 0.11);
    return vec4(x < 0.0 ? mix(vec3(0.94), low, -x) : mix(vec3(0.94), high, x), 1.0);
}
