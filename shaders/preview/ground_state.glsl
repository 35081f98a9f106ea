// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The ground at a fragment: means of the map over its footprint.
#include "preview/footprint.glsl"
#include "preview/ground.glsl"
#if COAST
#include "preview/coast_traces.glsl"
#endif

struct Ground {
    float height;       // [m]
    vec2 slope;
    float steepness;    // root of the mean square slope in the footprint
    float footprint;    // side of the ground that a pixel sees [m]
    float shore;        // -1 cliff .. 1 beach
    float streambed;    // 0 .. 1, as the others
    float deposit;
    float gully_wear;   // -1 floor of a gully .. 1 crest
    float wetted;       // by waves of a coast, 0 .. 1
    float still;        // share of water that stands still, beside a coast's windows
};

// Returns the map at a level of its mipmaps by cubic B-splines, as smooth as the eye needs where a
// texel covers many pixels: four linear reads [Sigg and Hadwiger 2005].
vec4 smooth_read(vec2 place, float mip) {
    vec2 size = vec2(textureSize(ground_map, int(mip)));
    vec2 at = place * size - 0.5;
    vec2 cell = floor(at);
    vec2 t = at - cell;
    vec2 s = 1.0 - t;
    vec2 first = s * s * s / 6.0, last = t * t * t / 6.0;
    vec2 second = 2.0 / 3.0 - 0.5 * t * t * (2.0 - t);
    vec2 lower = first + second;
    vec2 below = (cell - 0.5 + second / lower) / size;
    vec2 above = (cell + 1.5 + last / (1.0 - lower)) / size;
    return mix(mix(textureLod(ground_map, above, mip),
                   textureLod(ground_map, vec2(below.x, above.y), mip), lower.x),
               mix(textureLod(ground_map, vec2(above.x, below.y), mip),
                   textureLod(ground_map, below, mip), lower.x),
               lower.y);
}

Ground ground_at(vec2 at) {
    Footprint footprint = footprint_of(at);
    vec2 place = map_place(at);
    float side = length(footprint.longer);
    vec4 mean = filtered(ground_map, place, footprint, tile.z, 1.0 / tile.w);
    float far = smoothstep(0.5, 1.0, side / tile.w);
    if (far < 1.0) mean = mix(smooth_read(place, 0.0), mean, far);
    vec4 masks = textureLod(mask_map, place, log2(max(side / tile.w, 1.0)));
    vec2 sides = (2.0 * masks.xw - 1.0) * step(0.006, abs(masks.xw - 0.5));  // 128/255 is none
    float wetted = 0.0, still = 1.0;
#if COAST
    CoastReads reads = coast_reads(at);
    vec4 traces = coast_mean(coast_traces, reads, footprint);
    float reach = traces.w / max(reads.whole, 1e-3);
    float edge = max(0.02, fwidth(reach));  // [m]
    wetted = traces.z * smoothstep(-0.5 * edge, 0.5 * edge, reach);
    still = 1.0 - reads.whole;
#endif
    return Ground(mean.x, mean.yz, sqrt(max(mean.w, dot(mean.yz, mean.yz))), side, sides.x,
                  masks.y, masks.z, sides.y, wetted, still);
}
