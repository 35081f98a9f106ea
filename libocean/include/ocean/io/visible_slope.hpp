// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// What waves too small for a mesh do to the light.
#pragma once

namespace ocean::io {

/// Mean slope towards the eye of those facets of a rough surface that the eye sees. `slope_rms`: of
/// the slopes along the line of sight, Gaussian; `elevation_slope`: tangent of the eye's elevation
/// as seen from the mean surface, negative on a side turned away. See
/// shaders/wave/visible_slope.glsl.
double mean_visible_slope(double slope_rms, double elevation_slope);

}  // namespace ocean::io
