// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Light of the water for an eye below it.
#include "preview/below.glsl"
#include "preview/foam.glsl"
#include "preview/sky.glsl"
#include "preview/water_state.glsl"
#include "wave/reflectance.glsl"

// Returns the light from below: Snell's window, the whole sky in a cone of 48.6 degrees, broken by
// the waves, and the deep around it.
vec3 shaded_from_below(Water state, Foam froth) {
    vec3 from_eye = from_eye_here();
    float distance = max(length(from_eye), 1e-3);
    from_eye /= distance;
    vec3 normal = normal_of(state);
    vec2 lean = normal.xy / max(normal.z, 0.1) - state.detail;
    // Facets too small to be seen are windows if the sight meets them within the critical angle: a
    // share of a Gaussian below a limit, with a mean lean.
    vec2 e = from_eye.xy / max(length(from_eye.xy), 1e-3);
    mat2 covariance = mat2(state.variance.x, state.variance.z, state.variance.z, state.variance.y);
    vec2 along = covariance * e;
    float deviation = sqrt(max(dot(along, e), 1e-6));
    float met = acos(clamp(dot(from_eye, normalize(vec3(lean, 1.0))), -1.0, 1.0));
    float inside = (asin(1.0 / water.w) - met) / deviation;
    float windows = normal_distribution(inside);
    float shift = min(excess_over_mills(inside) - inside, 20.0);  // phi / Phi
    vec3 down = -normalize(vec3(lean + shift / deviation * along, 1.0));
    vec3 mirrored = water_glow(reflect(from_eye, -normalize(vec3(lean, 1.0))));
    vec3 outside = refract(from_eye, down, water.w);
    vec3 light = mirrored;
    if (dot(outside, outside) > 0.5) {
        float passed = 1.0 - water_reflectance(max(-dot(outside, down), 0.0), water.w);
        vec3 above = sky(normalize(vec3(outside.xy, abs(outside.z))), look.z);
        light = mix(mirrored, above, windows * passed);
    }
    // The sun through facets: the angle by which they turn it is a third of their lean.
    vec3 straight = refract(from_eye, -normalize(vec3(lean, 1.0)), water.w);
    if (dot(straight, straight) > 0.5) {
        float spread = 0.34 * 0.34 * 0.5 * (state.variance.x + state.variance.y) + 2e-5;
        float beside = 2.0 - 2.0 * dot(straight, sun.xyz);
        float passed = 1.0 - water_reflectance(max(straight.z, 0.0), water.w);
        // The radiance of a white surface is irradiance over pi.
        light += 0.5 * passed * sun.w * sun_colour.rgb * exp(-0.5 * beside / spread) / spread;
    }
    // Foam scatters half of its light down.
    vec3 foam_light = 0.5 * light_from_above();
    light = mix(light, mix(thick_foam, thin_foam, froth.thickness) * foam_light, froth.white);
    light += foam_plume * froth.plume * light_at_eye();
    return through_water(light, from_eye, distance);
}

// Returns whether the eye sees the surface from below. facing: a vector square to the surface
// between pixels.
bool is_underside(vec3 facing, vec3 from_eye) {
    float met = dot(facing, from_eye);
    // Far away the surface is edge-on, and its pixels do not decide.
    if (abs(met) < 2e-3 * length(facing) * length(from_eye)) return eye.z < 0.0;
    // An eye above an overhanging lip sees the lip's water behind it from above.
    float height = position.z + drop_at(label);
    return facing.z * met > 0.0 && (eye.z < height || height < 0.0);
}
