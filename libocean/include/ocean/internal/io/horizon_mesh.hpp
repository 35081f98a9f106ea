// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The sea up to the horizon as seen by one camera: a mesh that is fine near the camera.
#pragma once

#include <span>

#include "ocean/io/mesh.hpp"

namespace ocean::io {

/// A camera, and the resolution of its mesh.
struct View {
    double x = 0.0;               // position [m]
    double y = 0.0;               // [m]
    double height = 6.0;          // above still water [m]
    double heading = 0.0;         // [degrees] counter-clockwise from +x
    double field_of_view = 60.0;  // horizontal [degrees], 1 .. 150; the mesh has a margin around it
    double nearest = 0.0;         // distance of the first row [m]; 0 = chosen by the height
    double horizon = 0.0;  // of the last row [m]; 0 = where the Earth hides the highest crest
    int columns = 720;     // vertices from left to right
    int rows = 1800;       // vertices from near to far
    /// Slope variance of the waves too short for any map, such as those that a buoy does not
    /// measure. It is added to the slope variance of the filtered waves, because both scatter
    /// light.
    double unresolved_slope_variance = 0.0;
};

/// Returns the distance of the horizon of still water from `height` [m] above it, sqrt(2 R h) [m].
double horizon_distance(double height);

/// Returns a fan of the sea in front of a camera, dense near it and coarse far away, up to the
/// horizon of a round Earth. `levels` are periodic maps of one sea and time, the finest first, each
/// with half the resolution of the previous map. Each vertex samples the level that its distance
/// can resolve, so that nothing aliases, and its normal is turned to the camera by the mean slope
/// of the filtered waves that the camera would see (visible_slope.hpp). Needs dx, dy, height, nx,
/// ny, nz, slope_x and slope_y. Throws Error invalid_value.
Mesh make_horizon_mesh(std::span<const Surface> levels, const View& view);

}  // namespace ocean::io
