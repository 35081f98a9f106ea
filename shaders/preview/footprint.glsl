// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Means of a map over the area that a pixel covers. TAPS: samples along its longer axis; 0: the
// driver's anisotropic filter.

// The places that a pixel covers: an ellipse, long and narrow almost everywhere.
struct Footprint {
    vec2 dx;      // steps of the place from pixel to pixel [m]
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
