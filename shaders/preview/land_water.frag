// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The still water of a land with a coast: its bed, dimmed and tinted by the depth, under the sky and
// the land that it mirrors.
#include "preview/ground_light.glsl"
#include "preview/tone.glsl"
#include "wave/reflectance.glsl"

in float line_share;
layout(location = 0) out vec4 colour;

// Root of the mean square slope of ripples that are too small to draw.
const float ripple_slope = 0.06;

// Returns the light that comes from a direction: of the sky, or of wooded land that is in its way.
vec3 mirrored_light(vec3 direction, float footprint) {
    vec3 above = sky(direction, 0.1);
    float rise = direction.z / max(length(direction.xy), 1e-4);
    float reach = min((heights.w - water_line.x) / max(rise, 0.01), 1.0 / tile.z);
    vec2 towards = direction.xy / max(length(direction.xy), 1e-4);
    float open = free_way(label, water_line.x, towards, rise, reach, footprint);
    vec3 wooded = mix(forest_albedo, grass_albedo, 0.4) * light_from_above();
    return mix(wooded, above, open);
}

void main() {
    vec3 from_eye = position - vec3(0.0, 0.0, eye.z);
    float distance = length(from_eye);
    vec3 sight = from_eye / distance;
    vec2 lean = eye.w * label / earth_radius();
    vec3 normal = normalize(vec3(-lean, 1.0));
    float facing = max(-dot(sight, normal), 1e-3);

    float footprint = length(footprint_of(label).longer);
    vec2 at = map_place(label);
    float bed = ground_at(label).height;
    float depth = max(water_line.x - bed, 0.0);
    float sun_shown = sun.w > 0.0 ? free_sun(label, water_line.x, footprint) : 0.0;
    vec3 from_above = sky_light.rgb + sun_shown * sun.w * sun_colour.rgb * max(sun.z, 0.0);
    // The way down is that of a high sun; the way up leans as refraction lets it.
    float refracted = sqrt(1.0 - (1.0 - facing * facing) / (water.w * water.w));
    vec3 passed = exp(-loss.rgb * depth * (1.1 + 1.0 / refracted));
    vec3 body = mix(water.rgb, 0.7 * sand_albedo, passed) * from_above;

    float mirrored = rough_water_reflectance(facing, ripple_slope);
    vec3 away = reflect(sight, normal);
    away.z = abs(away.z);
    vec3 light = mix(body, mirrored_light(normalize(away), footprint), mirrored);
    vec3 half_way = normalize(sun.xyz - sight);
    float tilt = dot(half_way.xy, half_way.xy) / max(half_way.z * half_way.z, 1e-4);
    float glint = exp(-tilt / (ripple_slope * ripple_slope)) / (ripple_slope * ripple_slope);
    light += 0.02 * sun_shown * sun.w * glint * sun_colour.rgb / max(4.0 * facing, 0.2);

    // Waves break white where they run up the beach.
    float wash = 1.0 - smoothstep(0.0, 0.05, depth - 0.03 * cover_noise(label, footprint));
    light = mix(light, 0.75 * from_above, 0.5 * wash);

    float range_to = max(length(from_eye.xy), 1e-3);
    vec3 air = sky(normalize(vec3(from_eye.xy, 0.02 * range_to)), look.z);
    light = mix(light, air, look.y > 0.0 ? haze(distance, look.y) : 0.0);
    colour = vec4(drawn_colour(light), line_share);
}
