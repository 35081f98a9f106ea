// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The mean visible slope of waves too small for a mesh.
#pragma once

namespace ocean::io {

/// Returns the mean slope towards the eye of the facets of a rough surface that the eye sees.
/// `slope_rms` is the rms of the Gaussian slopes along the line of sight; `elevation_slope` is the
/// tangent of the eye's elevation above the mean surface, negative for a surface that is turned
/// away. See shaders/wave/visible_slope.glsl.
double mean_visible_slope(double slope_rms, double elevation_slope);

}  // namespace ocean::io
