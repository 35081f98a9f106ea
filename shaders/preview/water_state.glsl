// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The water at a fragment: means of the maps over its footprint, and the variance that is left in
// it.
#include "preview/sea.glsl"
#include "wave/slope_tiles.glsl"
#include "wave/surface.glsl"
#include "wave/visible_slope.glsl"

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
};

vec3 from_eye_here() { return position - vec3(0.0, 0.0, eye.z); }

// The water that a pixel covers: an ellipse of labels, long and narrow almost everywhere.
struct Footprint {
    vec2 dx;      // steps of the label from pixel to pixel
    vec2 dy;
    vec2 longer;  // the longer one
    float width;  // length of the shorter one [m]
};

Footprint footprint_of(vec2 at) {
    vec2 dx = dFdx(at);
    vec2 dy = dFdy(at);
    float x = length(dx);
    float y = length(dy);
    return x > y ? Footprint(dx, dy, dx, y) : Footprint(dx, dy, dy, x);
}

#if TAPS > 0
// Where the driver's filter is round, TAPS of its circles stand side by side along the longer axis:
// the mipmap of one with so many texels a metre, and the place of one.
float tap_level(Footprint footprint, float texels) {
    float circle = max(footprint.width, length(footprint.longer) / float(TAPS));
    return log2(max(circle * texels, 1.0));
}

vec2 tap_place(vec2 place, Footprint footprint, float scale, int tap) {
    float along = (float(tap) + 0.5) / float(TAPS) - 0.5;
    return place + along * scale * footprint.longer;
}
#endif

// The mean of a map over the footprint. scale: of the map's coordinates [1/m].
vec4 filtered(sampler2D map, vec2 place, Footprint footprint, float scale, float texels) {
#if TAPS > 0
    float mip = tap_level(footprint, texels);
    vec4 sum = vec4(0.0);
    for (int i = 0; i < TAPS; ++i) {
        sum += textureLod(map, tap_place(place, footprint, scale, i), mip);
    }
    return sum / float(TAPS);
#else
    return textureGrad(map, place, footprint.dx * scale, footprint.dy * scale);
#endif
}

vec4 filtered(sampler2DArray maps, float layer, vec2 place, Footprint footprint, float scale,
              float texels) {
#if TAPS > 0
    float mip = tap_level(footprint, texels);
    vec4 sum = vec4(0.0);
    for (int i = 0; i < TAPS; ++i) {
        sum += textureLod(maps, vec3(tap_place(place, footprint, scale, i), layer), mip);
    }
    return sum / float(TAPS);
#else
    return textureGrad(maps, vec3(place, layer), footprint.dx * scale, footprint.dy * scale);
#endif
}

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

