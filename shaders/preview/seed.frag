// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The light of the teaching programs: ambient, diffuse and specular with a half vector
// [Blinn 1977], and a fog that is linear and full at 500 m. Colours are the screen's own.
#include "preview/frame.glsl"

in vec3 position;
in vec3 normal;
layout(location = 0) out vec4 colour;

void main() {
    vec3 to_eye = vec3(0.0, 0.0, eye.z) - position;
    vec3 up = normalize(normal);
    vec3 half_way = normalize(sun.xyz + normalize(to_eye));
    float facing = max(dot(up, sun.xyz), 0.0);
    float mirrored = facing > 0.0 ? pow(max(dot(up, half_way), 0.0), 120.0) : 0.0;

    vec3 white = vec3(1.0, 0.98, 0.94);
    vec3 ambient = vec3(0.01, 0.05, 0.12);
    vec3 diffuse = vec3(0.08, 0.33, 0.54);
    vec3 lit = ambient + white * (facing * diffuse + 0.9 * mirrored);
    colour = vec4(mix(lit, sky_low.rgb, min(length(to_eye) / 500.0, 1.0)), 1.0);
}
