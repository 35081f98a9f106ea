// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Light of the water for an eye above it.
#include "preview/foam.glsl"
#include "preview/sky.glsl"
#include "preview/water_state.glsl"
#include "wave/crest_light.glsl"
#include "wave/haze.glsl"
#include "wave/reflectance.glsl"
#include "preview/sand.glsl"
#if COAST
#include "preview/caustics.glsl"
#endif

// Returns the light of the sun that facets mirror: the density of their slopes at the slope that
// mirrors it into the eye, over the visible area of water [Cox and Munk 1954], [Ross 2005].
vec3 glitter(vec3 to_eye, vec2 lean, mat2 covariance, float area, float elevation_cosine) {
    vec3 half_way = normalize(to_eye + sun.xyz);
    if (half_way.z <= 0.05) return vec3(0.0);
    float spread = 0.00465 * 0.5;  // the sun's radius, as a slope
    mat2 v = covariance + mat2(spread * spread + look.z * look.z * 0.25);
    float determinant_v = max(determinant(v), 1e-14);
    vec2 miss = half_way.xy / half_way.z - lean;
    vec2 solved = vec2(v[1][1] * miss.x - v[0][1] * miss.y, v[0][0] * miss.y - v[0][1] * miss.x);
    float density = exp(-0.5 * dot(miss, solved) / determinant_v) /
                    (6.2831853 * sqrt(determinant_v));
    float reflected = water_reflectance(max(dot(to_eye, half_way), 0.0), water.w);
    float squared = half_way.z * half_way.z;
    float seen = max(area * elevation_cosine, 1e-3);
    return 3.14159265 * sun.w * sun_colour.rgb * reflected * density /
           (4.0 * seen * squared * squared);
}

// Returns the mean of the sky over the facets that mirror it: three points along the line of sight,
// in whose direction the mirrored sky varies fastest. across: the spread the other way [rad].
vec3 mirrored_sky(vec3 to_eye, vec2 lean, vec2 deviation, float across) {
    vec3 sum = vec3(0.0);
    for (int i = -1; i <= 1; ++i) {
        vec3 facet = normalize(vec3(lean + float(i) * 1.7320508 * deviation, 1.0));
        vec3 mirrored = reflect(-to_eye, facet);
        mirrored.z = abs(mirrored.z);  // a second reflection
        sum += (i == 0 ? 2.0 / 3.0 : 1.0 / 6.0) * sky(normalize(mirrored), across);
    }
    return sum;
}

#if COAST
// Returns the light that leaves the bed below a fragment. shown: the share of it that the eye sees.
vec3 bed_light(Water state, vec3 to_eye, vec3 shown) {
    float focus = 1.0;
    bool is_seen = max(shown.r, max(shown.g, shown.b)) > 0.02 && state.open < 1.0;
    if (is_seen && sun.w > 0.0 && sun.z > 0.1) {
        focus = caustic(label, to_eye, max(state.depth, 0.0), state.footprint);
    }
    return wet_sand_albedo * (sky_light.rgb + focus * sun.w * sun_colour.rgb * max(sun.z, 0.0));
}
#endif

vec3 shaded(Water state, Foam froth, vec2 froth_slope) {
    vec3 from_eye = from_eye_here();
    float distance = max(length(from_eye), 1e-3);
    vec3 to_eye = -from_eye / distance;
    float range = max(length(from_eye.xy), 1e-3);
    vec2 e = -from_eye.xy / range;

    // A folded crest has no slope; the shallowest kept is 84 degrees.
    vec3 normal = normal_of(state);
    vec2 lean =
        normal.xy / max(normal.z, 0.1) - state.detail - e * (eye.w * range / earth_radius());
    mat2 covariance = mat2(state.variance.x, state.variance.z, state.variance.z, state.variance.y);
    vec2 along = covariance * e;
    float variance = max(dot(along, e), 1e-12);
    float deviation = sqrt(variance);
    float elevation = -from_eye.z / range + dot(lean, e);
    float area = visible_area(deviation, elevation);
    vec2 seen = lean + along * (visible_lean(deviation, elevation) / variance);
    float mean_cosine = max(dot(to_eye, normalize(vec3(lean, 1.0))), 0.0);
    float reflected = clamp(rough_water_reflectance(mean_cosine, deviation), 0.0, 1.0);
    vec2 spread = along / variance * sqrt(visible_lean_variance(deviation, elevation));
    // A facet that leans aside turns the mirrored ray by twice the angle, times the cosine; a mean
    // over sqrt(12) deviations is as wide.
    vec2 aside = vec2(-e.y, e.x);
    float across = 6.9 * mean_cosine * sqrt(max(dot(covariance * aside, aside), 0.0));
    vec3 mirrored = mirrored_sky(to_eye, seen, spread, max(across, look.z));

    vec3 albedo = water.rgb + foam_plume * froth.plume;
    vec3 passed = vec3(0.0);  // share of the light of the bed
#if COAST
    // The way down is that of a high sun; the way up leans as refraction lets it.
    float refracted = sqrt(1.0 - (1.0 - mean_cosine * mean_cosine) / (water.w * water.w));
    passed = exp(-loss.rgb * max(state.depth, 0.0) * (1.1 + 1.0 / refracted));
    vec3 shown = passed * (1.0 - reflected) * (1.0 - froth.white);
    vec3 body = mix(albedo * light_from_above(), bed_light(state, to_eye, shown), passed);
#else
    vec3 body = albedo * light_from_above();
#endif
    float through = crest_light(state.displacement.z / max(waves.y, 1e-3), jacobian_of(state),
                                dot(-to_eye.xy, sun.xy), dot(normal.xy, sun.xy));
    body += crest.w * through * sun.w * sun_colour.rgb * crest.rgb * (1.0 - passed);

    vec3 radiance = reflected * mirrored + (1.0 - reflected) * body +
                    glitter(to_eye, lean, covariance, area, range / distance);
    vec3 facing = normalize(vec3(lean - froth_slope, 1.0));
    vec3 foam_light = sky_light.rgb + sun.w * sun_colour.rgb * max(dot(facing, sun.xyz), 0.0);
    radiance = mix(radiance, mix(thin_foam, thick_foam, froth.thickness) * foam_light, froth.white);
    // The light of the air is that of the sky over the horizon.
    vec3 air = sky(normalize(vec3(from_eye.xy, 0.02 * range)), look.z);
    return mix(radiance, air, look.y > 0.0 ? haze(distance, look.y) : 0.0);
}
