// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The light of the water, or a field of it.
#include "preview/sea.glsl"
#include "preview/sky.glsl"
#include "preview/tone.glsl"
#include "wave/erfc.glsl"
#include "wave/reflectance.glsl"
#include "wave/surface.glsl"
#include "wave/visible_slope.glsl"

in vec2 label;
in vec3 position;
layout(location = 0) out vec4 colour;

// The sea at a fragment: means over its footprint, and what varies inside.
struct Water {
    vec4 displacement;  // as displacement_map
    vec4 gradients;     // as gradient_map
    vec3 variance;      // of the slopes that are not in the means: xx, yy, xy
    float squeezing;    // variance of dDx/dx + dDy/dy that is not in the mean
    float cover;        // of foam
};

// What a pixel covers of the water: an ellipse of labels, long and narrow almost everywhere.
struct Footprint {
    vec2 dx;      // steps of the label from pixel to pixel
    vec2 dy;
    vec2 longer;  // the longer one
    float width;  // m: the length of the other one
};

Footprint footprint_of(vec2 at) {
    vec2 dx = dFdx(at);
    vec2 dy = dFdy(at);
    float x = length(dx);
    float y = length(dy);
    return x > y ? Footprint(dx, dy, dx, y) : Footprint(dx, dy, dy, x);
}

// A map's mean over the footprint. Where the driver's filter is round, TAPS of its circles stand
// side by side along the longer axis.
vec4 filtered(sampler2D map, vec2 place, Footprint footprint, float scale, float texels) {
#if TAPS > 0
    float longer = length(footprint.longer);
    float circle = max(footprint.width, longer / float(TAPS));
    float mip = log2(max(circle * texels, 1.0));
    vec4 sum = vec4(0.0);
    for (int i = 0; i < TAPS; ++i) {
        float along = (float(i) + 0.5) / float(TAPS) - 0.5;
        sum += textureLod(map, place + along * scale * footprint.longer, mip);
    }
    return sum / float(TAPS);
#else
    return textureGrad(map, place, footprint.dx * scale, footprint.dy * scale);
#endif
}

Water water_at(vec2 at) {
    Footprint footprint = footprint_of(at);
    Water water = Water(vec4(0.0), vec4(0.0), vec3(0.0), 0.0, 0.0);
    Copies copies = copies_at(at);
    float resolved = 0.0;  // mean square slope of the maps
    for (int c = 0; c < CASCADES; ++c) {
        float scale = cascade[c].z;
        vec4 all = part[c].x * part[c].x * textureLod(moment_map[c], vec2(0.5), 99.0);
        resolved += all.x + all.y;
        if (length(footprint.longer) * scale >= 1.0) {  // the footprint is larger than the period
            water.variance += all.xyz;
            water.squeezing += all.w;
            continue;
        }
        for (int i = 0; i < copies.count; ++i) {
            float weight = part[c].x * copies.weight[i];
            vec2 place = map_place(c, at, copies.offset[i]);
            float texels = 1.0 / cascade[c].w;
            vec4 gradients = filtered(gradient_map[c], place, footprint, scale, texels);
            vec4 moments = filtered(moment_map[c], place, footprint, scale, texels);
            water.displacement +=
                weight * filtered(displacement_map[c], place, footprint, scale, texels);
            water.gradients += weight * gradients;
            vec3 squares = vec3(gradients.x * gradients.x, gradients.y * gradients.y,
                                gradients.x * gradients.y);
            float squeezed = gradients.z + gradients.w;
            // Copies are independent: variances add by the squares of their weights.
            water.variance += weight * weight * (moments.xyz - squares);
            water.squeezing += weight * weight * (moments.w - squeezed * squeezed);
        }
    }
    water.variance = max(water.variance, vec3(0.0, 0.0, water.variance.z));
    water.variance.xy += 0.5 * max(0.0, waves.z - resolved);  // of waves that no map has
    for (int v = 0; v < COVERS; ++v) {
        float squares = 0.0;
        float sum = 0.0;
        for (int i = 0; i < copies.count; ++i) {
            vec2 place = cover[v].xy + at * cover[v].z + copies.offset[i] + 0.5 * cover[v].w;
            float share = copies.weight[i] * copies.weight[i];
            float texels = cover[v].z / cover[v].w;  // a metre
            sum += share * filtered(cover_map[v], place, footprint, cover[v].z, texels).r;
            squares += share;
        }
        water.cover += cover_share[v] * sum / squares;
    }
    water.cover = clamp(water.cover, 0.0, 1.0);
    return water;
}

float jacobian_of(Water water) {
    return surface_jacobian(waves.x, water.gradients.z, water.gradients.w, water.displacement.w);
}

vec3 normal_of(Water water) {
    SurfaceNormal normal = surface_normal(waves.x, water.gradients.z, water.gradients.w,
                                          water.displacement.w, water.gradients.x, water.gradients.y);
    return vec3(normal.x, normal.y, normal.z);
}

// Light of the sun mirrored by facets: the density of their slopes at the one that mirrors it into
// the eye, over the area of water that is seen [Cox and Munk 1954], [Ross 2005].
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
    return 3.14159265 * sun.w * sun_colour.rgb * reflected * density / (4.0 * seen * squared * squared);
}

// The mean of the sky over the facets that mirror it: three points along the line of sight, which
// is the way that the mirrored sky varies most. across: radians that they spread it the other way.
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

vec3 shaded(Water state) {
    vec3 from_eye = position - vec3(0.0, 0.0, eye.z);
    float distance = max(length(from_eye), 1e-3);
    vec3 to_eye = -from_eye / distance;
    float range = max(length(from_eye.xy), 1e-3);
    vec2 e = -from_eye.xy / range;

    // A folded crest has no slope; the shallowest kept is 84 degrees.
    vec3 normal = normal_of(state);
    vec2 lean = normal.xy / max(normal.z, 0.1) - e * (eye.w * range / earth_radius());
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
    // A facet that leans aside turns what it mirrors by twice as much, times the cosine; as wide as
    // that deviation is a mean over sqrt(12) of it.
    vec2 aside = vec2(-e.y, e.x);
    float across = 6.9 * mean_cosine * sqrt(max(dot(covariance * aside, aside), 0.0));
    vec3 mirrored = mirrored_sky(to_eye, seen, spread, max(across, look.z));

    float sun_cosine = max(dot(normalize(vec3(lean, 1.0)), sun.xyz), 0.0);
    vec3 light = sky_light.rgb + sun.w * sun_colour.rgb * max(sun.z, 0.0);
    vec3 body = water.rgb * light;
    // Crests with the sun behind them: what went in on the far side comes out on this one.
    float behind = max(dot(-to_eye.xy, normalize(sun.xy + vec2(1e-6))), 0.0);
    float crest = clamp(state.displacement.z / max(waves.y, 1e-3), 0.0, 1.0);
    float thin = crest * crest * max(1.0 - normal.z, 0.0) * 4.0;
    body += water.rgb * sun.w * sun_colour.rgb * behind * behind * thin;

    vec3 radiance = reflected * mirrored + (1.0 - reflected) * body +
                    glitter(to_eye, lean, covariance, area, range / distance);
    float white = clamp(state.cover * foam.w, 0.0, 1.0);
    vec3 foam_light = foam.z * (sky_light.rgb + sun.w * sun_colour.rgb * sun_cosine);
    radiance = mix(radiance, foam_light, white);
    float haze = 1.0 - exp(-distance / look.y);
    vec3 horizon = sky(normalize(vec3(from_eye.xy, 0.0)), look.z);
    return mix(radiance, horizon, haze);
}

// Blue below 0, white at 0, red above, of values in -1 .. 1.
vec3 two_sided(float x) {
    x = clamp(x, -1.0, 1.0);
    vec3 low = vec3(0.11, 0.30, 0.62);
    vec3 high = vec3(0.66, 0.13, 0.11);
    return x < 0.0 ? mix(vec3(0.94), low, -x) : mix(vec3(0.94), high, x);
}

void main() {
    Water state = water_at(label);
    float width = max(range.y - range.x, 1e-9);
    if (view.x == VIEW_shaded) {
        colour = vec4(drawn_colour(shaded(state)), 1.0);
    } else if (view.x == VIEW_normal) {
        colour = vec4(0.5 + 0.5 * normal_of(state), 1.0);
    } else if (view.x == VIEW_slope) {
        colour = vec4(clamp(0.5 + state.gradients.xy / width, 0.0, 1.0), 0.5, 1.0);
    } else if (view.x == VIEW_foam) {
        colour = vec4(vec3(state.cover), 1.0);
    } else if (view.x == VIEW_whitecap) {
        colour = vec4(vec3(surface_whitecap(jacobian_of(state), foam.x, foam.y)), 1.0);
    } else if (view.x == VIEW_numbers) {
        // For probes: height that the mesh draws, height of the maps here, mean square slope shown,
        // mean square slope handed on to the light.
        vec2 s = state.gradients.xy;
        colour = vec4(position.z + drop_at(label), state.displacement.z, dot(s, s),
                      state.variance.x + state.variance.y);
    } else {
        float value = state.displacement.z;
        if (view.x == VIEW_displacement_x) value = -waves.x * state.displacement.x;
        if (view.x == VIEW_displacement_y) value = -waves.x * state.displacement.y;
        if (view.x == VIEW_jacobian) value = jacobian_of(state);
        colour = vec4(two_sided(2.0 * (value - range.x) / width - 1.0), 1.0);
    }
}
