// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The sum over all maps at a label: cascades, near detail and foam.
#include "preview/water_state.glsl"
#include "wave/foam_lace.glsl"
#include "preview/foam_look.glsl"
#if DETAIL > 0
#include "preview/near_detail.glsl"
#endif

// Adds the cascades from `first` up to `end`, whose maps lie in one array each. resolved: mean
// square slope of the maps, to which theirs is added.
void add_maps(inout Water water, inout float resolved, sampler2DArray displacements,
              sampler2DArray gradient_array, sampler2DArray moment_array, int first, int end,
              Copies copies, vec2 at, Footprint footprint) {
    for (int c = first; c < end; ++c) {
        float scale = cascade[c].z;
        float layer = part[c].z;
        vec4 all = part[c].x * part[c].x * textureLod(moment_array, vec3(0.5, 0.5, layer), 99.0);
        resolved += all.x + all.y;
        if (water.open <= 0.0) continue;
        if (length(footprint.longer) * scale >= 1.0) {  // the footprint is larger than the period
            water.variance += all.xyz;
            water.squeezing += all.w;
            continue;
        }
        for (int i = 0; i < copies.count; ++i) {
            float weight = part[c].x * copies.weight[i];
            vec2 place = map_place(c, at, copies.offset[i]);
            float texels = 1.0 / cascade[c].w;
            vec4 gradients = filtered(gradient_array, layer, place, footprint, scale, texels);
            vec4 moments = filtered(moment_array, layer, place, footprint, scale, texels);
            water.displacement +=
                weight * filtered(displacements, layer, place, footprint, scale, texels);
            water.gradients += weight * gradients;
            vec3 squares = vec3(gradients.x * gradients.x, gradients.y * gradients.y,
                                gradients.x * gradients.y);
            float squeezed = gradients.z + gradients.w;
            // Copies are independent: variances add by the squares of their weights.
            water.variance += weight * weight * (moments.xyz - squares);
            water.squeezing += weight * weight * (moments.w - squeezed * squeezed);
        }
    }
}

#if COAST
uniform sampler2DArray coast_gradients;  // as gradient_maps
uniform sampler2DArray coast_moments;    // squares of the slopes, their product, dDx/dy

// Blends the windows of the coast in.
void add_windows(inout Water water, CoastReads reads, Footprint footprint) {
    if (reads.count == 0) return;
    vec4 shape = coast_shape(reads);
    vec4 gradients = coast_mean(coast_gradients, reads, footprint);
    vec4 moments = coast_mean(coast_moments, reads, footprint);
    water.displacement = mix(water.displacement, vec4(shape.xyz, 0.0), reads.whole);
    water.displacement.w += moments.w;
    vec2 slope = gradients.xy / reads.whole;
    water.gradients = water.open * water.gradients + gradients;
    water.variance = water.open * water.variance + moments.xyz -
                     reads.whole * vec3(slope * slope, slope.x * slope.y);
    water.squeezing *= water.open;
    water.depth = mix(water.depth, shape.w, reads.whole);
}

// Lays the foam of breaking waves over that of the open sea, whose whitecaps do not break where
// waves feel the bed: by their height over the depth, as the core has it. Where a sea breaks over a
// wake, that whitecap is foam.
void add_surf(inout Water water, CoastReads reads, Footprint footprint) {
    vec4 traces = coast_mean(coast_traces, reads, footprint);
    float rms = 0.7071 * waves.y;
    float surf = (1.0 - water.open) * smoothstep(0.12, 0.22, rms / max(water.depth, 0.1));
    float line = swash_foam(water.depth) * min(2.0 * waves.y, 1.0) * (1.0 - water.open);
    // At its end the lace of foam opens.
    float white = max(traces.x, line) * smoothstep(0.0, swash_tip, water.depth);
    float thick = white * foam_mean_thickness(white, foam_span);
    float caps = coast_count.y > 0 ? 0.0 : traces.w;
    vec2 cap = caps * vec2(1.0, foam_mean_thickness(caps, foam_span));
    for (int v = 0; v < COVERS; ++v) {
        vec3 open = (1.0 - surf) * water.foam[v];
        open.rg = max(open.rg, cap);
        water.foam[v].rg = 1.0 - (1.0 - open.rg) * (1.0 - vec2(white, thick));
        water.foam[v].b = max(open.b, traces.y);
    }
}
#endif

// [m] Waves that no map has end where the water is shallower: a sheet on sand has none.
const float detail_depth = 0.5;

Water water_at(vec2 at) {
    Footprint footprint = footprint_of(at);
    Water water;
    water.displacement = water.gradients = vec4(0.0);
    water.detail = vec2(0.0);
    water.variance = vec3(0.0);
    water.squeezing = 0.0;
    water.open = 1.0;
    water.depth = 1e3;
#if COAST
    CoastReads reads = coast_reads(at);
    water.open = 1.0 - reads.whole;
#endif
    Copies copies = copies_at(at);
    float resolved = 0.0;  // mean square slope of the maps
    add_maps(water, resolved, displacement_maps[0], gradient_maps[0], moment_maps[0], 0, SPLIT,
             copies, at, footprint);
#if MAPS > 1
    add_maps(water, resolved, displacement_maps[1], gradient_maps[1], moment_maps[1], SPLIT,
             CASCADES, copies, at, footprint);
#endif
#if COAST
    add_windows(water, reads, footprint);
#endif
    water.variance = max(water.variance, vec3(0.0, 0.0, water.variance.z));
    water.footprint = seen_footprint(water);
    float lacking = max(0.0, waves.z - resolved);  // of waves that no map has
    lacking *= smoothstep(0.0, detail_depth, water.depth);
#if DETAIL > 0
    lacking -= add_detail(water, at, lacking);
#endif
    water.variance.xy += 0.5 * lacking;
    for (int v = 0; v < COVERS; ++v) {
        float squares = 0.0;
        vec3 sum = vec3(0.0);
        for (int i = 0; i < copies.count; ++i) {
            vec2 place = cover[v].xy + at * cover[v].z + copies.offset[i] + 0.5 * cover[v].w;
            float share = copies.weight[i] * copies.weight[i];
            float texels = cover[v].z / cover[v].w;  // a metre
            sum += share * filtered(cover_map[v], place, footprint, cover[v].z, texels).rgb;
            squares += share;
        }
        water.foam[v] = sum / squares;
    }
#if COAST
    add_surf(water, reads, footprint);
#endif
    return water;
}
