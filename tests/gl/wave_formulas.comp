#version 450
// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Uses every formula of shaders/wave/ once, so that none is dropped unread by the compiler.
#extension GL_GOOGLE_include_directive : require
#define real float
#define formula
#define splitter 4097.0
#include "wave/turns.glsl"
#include "wave/noise.glsl"
#include "wave/dispersion.glsl"
#include "wave/phase.glsl"
#include "wave/copies.glsl"
#include "wave/crest_light.glsl"
#include "wave/erfc.glsl"
#include "wave/foam_cover.glsl"
#include "wave/foam_lace.glsl"
#include "wave/haze.glsl"
#include "wave/horizon.glsl"
#include "wave/reflectance.glsl"
#include "wave/slope_tiles.glsl"
#include "wave/surface.glsl"
#include "wave/visible_slope.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = 0) buffer Result { vec4 result[]; };

void main() {
    uint id = gl_GlobalInvocationID.x;
    Gaussian xi = gaussian_noise(1u, 0u, int(id), -int(id));
    float k = 0.01 * float(id + 1u);
    float omega = angular_frequency(k, 9.81, 7.4e-5, 100.0);
    float turns = phase_turns(omega / 6.2831853, 0.0, 12.0, 0.0);
    ModeState state = mode_state(xi.re, xi.im, xi.im, xi.re, turns, omega);
    SurfaceNormal normal = surface_normal(1.0, 0.1, 0.2, 0.05, state.re, state.im);
    float area = surface_jacobian(1.0, 0.1, 0.2, 0.05);
    area += foam_cover(surface_whitecap(area, 0.75, 0.2), 3.0);
    area += visible_lean(0.1, area) + visible_area(0.1, area);
    area += water_reflectance(0.5, 1.333) + rough_water_reflectance(0.5, 0.1);
    area += earth_drop(horizon_distance(k));
    GridPoint grid = copy_grid(area, 0.5);
    area += copy_corner(fract(grid.x), fract(grid.y), 1).weight + copy_offset(1, -2).y;
    SlopeTileRead read = slope_tile_read(area, 0.5, 2);
    float fade = slope_tile_fade(slope_footprint(10.0, 0.001, area), 0.1, 0.6);
    area += read.weight * (read.x + read.y) + slope_tile_left(fade, 0.01);
    float lace = unite_uniform(add_uniform(k, area, 0.3), 0.5, 0.1);
    area += foam_faded(foam_mask(0.2, lace, foam_pixel_edge(0.1, k, 0.86)), 0.2, k, 0.86);
    area += foam_in_streaks(k, lace, 0.3) + foam_bubbles(k, 0.2, lace);
    area += foam_pixel_thickness(k, area, k, 0.86);
    area += crest_light(area, 0.5, k, -0.2) + haze(area, 4e4);
    area += foam_thickness(0.2, lace, 0.35) + foam_mean_thickness(k, 0.35);
    result[id] = vec4(normal.x + normal.y, normal.z * group_velocity(k, 9.81, 7.4e-5, 100.0),
                      area * horizontal_displacement(k, 100.0), state.rate_re + state.rate_im);
}
