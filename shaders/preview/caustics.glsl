// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Sunlight that the waves of a coast focus on its bed. Rays go through a lattice of places of the
// water, and each gives its light to the bed around the place that it meets: also where several
// rays meet, and with the light of level water in the mean.
#include "preview/coast_traces.glsl"
#include "preview/water_state.glsl"
#if DETAIL > 0
#include "preview/near_detail.glsl"
#endif

// Returns the slope of the windows at a label, in the mean over a circle [m].
vec2 window_slope(vec2 at, float width) {
    return coast_mean(coast_gradients, coast_reads(at), width).xy;
}

// Returns the slope of the waves that are shorter.
vec2 short_slope(vec2 at, float width) {
    vec2 slope = vec2(0.0);
#if DETAIL > 0
    for (int d = 0; d < DETAIL; ++d) {
        float fade = slope_tile_fade(width, tile_grid[d].z, tile_grid[d].w);
        if (fade <= 0.0) continue;
        float texels = width * tile[d].z * float(tile_cell[d].w);
        int level = clamp(int(floor(log2(max(texels, 1.0)))), 0, 7);
        bool is_first = TILE_MAPS == 1 || d < TILE_SPLIT;
        slope += fade * tile[d].w *
                 tile_slope(tile_maps[is_first ? 0 : TILE_MAPS - 1], d, at, level);
    }
#endif
    return slope;
}

vec2 slope_over(vec2 at, float width) {
    return window_slope(at, width) + short_slope(at, width);
}

// Returns how far from the place above it a ray from above meets a bed at a depth [m].
vec2 ray_shift(vec3 from_above, vec2 slope, float depth) {
    vec3 ray = refract(from_above, normalize(vec3(-slope, 1.0)), 1.0 / water.w);
    return depth * ray.xy / max(-ray.z, 0.1);
}

// Returns the light of the sun on the bed that an eye sees at a label, in units of that below level
// water. pixel: the side of the water that a pixel sees [m].
float caustic(vec2 at, vec3 to_eye, float depth, float pixel) {
    // A lattice of nine places catches the rays if its step is twice the rms distance by which the
    // waves turn them aside. Sights are turned by the same waves, and blurred as much by those that
    // the lattice does not hold. Where a pixel covers more the net is coarser, and ends before it
    // is even.
    float aside = 2.0 * (1.0 - 1.0 / water.w) * depth * sqrt(0.5 * waves.z);
    float least = max(aside, 0.02);
    float shown = waves.z > 0.0 ? 1.0 - smoothstep(1.0, 2.0, pixel / least) : 0.0;
    if (shown <= 0.0) return 1.0;
    float step = max(least, pixel);
    // The lattice lies around the place whose ray the long waves send to the bed that is seen.
    vec2 bed = at + ray_shift(-to_eye, slope_over(at, step), depth);
    vec2 above = bed - ray_shift(-sun.xyz, vec2(0.0), depth);
    vec2 long_shift = ray_shift(-sun.xyz, slope_over(above, 4.0 * step), depth);
    vec2 middle = bed - long_shift;
    // The windows' slopes change little over the lattice.
    vec2 level = window_slope(middle, step);
    vec2 along_x = window_slope(middle + vec2(step, 0.0), step) - level;
    vec2 along_y = window_slope(middle + vec2(0.0, step), step) - level;
    float light = 0.0;
    for (int j = -1; j <= 1; ++j) {
        for (int i = -1; i <= 1; ++i) {
            vec2 from = step * vec2(i, j);
            vec2 slope = level + float(i) * along_x + float(j) * along_y +
                         short_slope(middle + from, 0.5 * step);
            vec2 met = from + ray_shift(-sun.xyz, slope, depth) - long_shift;
            vec2 near = max(1.0 - abs(met) / step, 0.0);
            light += near.x * near.y;
        }
    }
    return mix(1.0, light, shown);
}
