// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The sky, as Ocean_Sky of povray_macros/ocean/sky.inc or as the map of an environment: one
// function for the background and for the mirrored sky.
#include "preview/frame.glsl"

uniform sampler2D sky_map;  // over longitude and latitude, from the horizon to the zenith

float toward_sun(vec3 direction) { return max(0.0, dot(direction, sun.xyz)); }

// Returns the light of the map. up: direction.z, as in sky(). width: see sky() [rad].
vec3 mapped_sky(vec3 direction, float up, float width) {
    float level = length(direction.xy);
    float bearing = level > 0.0 ? atan(direction.y, direction.x) : 0.0;
    float elevation = atan(max(up, 0.0), level);
    float texels = width * float(textureSize(sky_map, 0).y) / 1.5707963;
    vec2 place = vec2(0.5 + sky_high.w - bearing / 6.2831853, elevation / 1.5707963);
    return textureLod(sky_map, place, log2(max(texels, 1.0))).rgb;
}

// Returns the light of the sky without the sun's disc. direction: a unit vector. width: angle
// around it [rad] over which a map is averaged.
vec3 sky(vec3 direction, float width) {
    float up = max(direction.z, 0.0) + min(direction.z + sky_low.w, 0.0);
    float below = mix(1.0, 0.35, clamp(-up / 0.0111, 0.0, 1.0));  // the horizon: other waves
    if (sky_middle.w > 0.0) return below * mapped_sky(direction, up, width);
    vec3 lower = 0.5 * (sky_low.rgb + sky_middle.rgb);
    vec3 colour = mix(sky_low.rgb, lower, clamp(up / 0.0667, 0.0, 1.0));
    vec3 upper = 0.75 * sky_middle.rgb + 0.25 * sky_high.rgb;
    colour = mix(colour, upper, clamp((up - 0.0667) / 0.2, 0.0, 1.0));
    colour = mix(colour, sky_high.rgb, clamp((up - 0.2667) / 0.3444, 0.0, 1.0));
    colour = mix(colour, 0.7 * sky_high.rgb, clamp((up - 0.6111) / 0.3889, 0.0, 1.0));
    colour *= below;
    float away = 0.5 - 0.5 * dot(direction, sun.xyz);
    colour = mix(colour, sky_shadow.rgb, 0.85 * sky_shadow.a * away);
    float near = toward_sun(direction);
    float glow = clamp(0.3 * pow(near, 16.0) + 0.7 * sun.w * pow(near, 700.0), 0.0, 1.0);
    return mix(colour, (1.0 + 0.6 * glow) * sun_colour.rgb, glow);
}

// Returns the light of a level white surface under sky and sun.
vec3 light_from_above() { return sky_light.rgb + sun.w * sun_colour.rgb * max(sun.z, 0.0); }

// Returns the light of the sun's disc, with an edge of a pixel.
vec3 sun_disc(vec3 direction) {
    float beside = acos(clamp(dot(direction, sun.xyz), -1.0, 1.0));
    float radius = 0.00465;
    float inside = 1.0 - smoothstep(radius - look.z, radius + look.z, beside);
    return 60.0 * sun.w * inside * sun_colour.rgb;
}
