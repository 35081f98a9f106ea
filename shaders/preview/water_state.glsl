// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The water at a fragment: means of the maps over its footprint, and the variance that is left in
// it.
#include "preview/footprint.glsl"
#include "preview/sea.glsl"
#include "wave/slope_tiles.glsl"
#include "wave/surface.glsl"
#include "wave/visible_slope.glsl"
#if COAST
#include "preview/coast_traces.glsl"
#endif

in vec2 label;
in vec3 position;

// The sea at a fragment: means over its footprint, and what varies inside.
struct Water {
    vec4 displacement;  // as displacement_maps
    vec4 gradients;     // as gradient_maps
    vec2 detail;        // slopes of waves that no map has
    vec3 variance;      // of the slopes in neither of both: xx, yy, xy
    float squeezing;    // variance of dDx/dx + dDy/dy that is not in the mean
    vec3 foam[COVERS];  // as cover_map
    float footprint;    // side of the water that a pixel sees [m]
    float open;         // share of the open sea beside a coast's windows
    float depth;        // over the bed [m]; of the open sea more than light passes
};

vec3 from_eye_here() { return position - vec3(0.0, 0.0, eye.z); }

float jacobian_of(Water water) {
    return surface_jacobian(waves.x, water.gradients.z, water.gradients.w, water.displacement.w);
}

vec3 normal_of(Water water) {
    vec4 g = water.gradients;
    SurfaceNormal normal =
        surface_normal(waves.x, g.z, g.w, water.displacement.w, g.x, g.y);
    return vec3(normal.x, normal.y, normal.z);
}

vec2 slope_of(Water water) { return water.gradients.xy + water.detail; }

// The normal with the slopes of the near detail, which lie on a surface that is not folded.
vec3 detailed_normal_of(Water water) {
    vec3 normal = normal_of(water);
    normal.xy -= max(normal.z, 0.0) * water.detail;
    return normalize(normal);
}

// Returns the side of the water that a pixel sees [m]. Behind a ridge the angle is grazing at any
// distance.
float seen_footprint(Water water) {
    vec3 from_eye = from_eye_here();
    float distance = max(length(from_eye), 1e-3);
    return slope_footprint(distance, look.z, max(-dot(normal_of(water), from_eye) / distance, 0.0));
}

