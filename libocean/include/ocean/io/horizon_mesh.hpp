// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The sea as one eye sees it, to the horizon: a mesh that is fine where the eye looks.
#pragma once

#include <span>

#include "ocean/io/mesh.hpp"

namespace ocean::io {

/// Where a picture is taken from: what of the sea a mesh must show, and how finely.
struct View {
    double x = 0.0;  // eye, m
    double y = 0.0;
    double height = 6.0;          // above still water, m
    double heading = 0.0;         // degrees counter-clockwise from +x
    double field_of_view = 60.0;  // horizontal, degrees, 1 .. 150; the mesh has a margin around it
    double nearest = 0.0;         // first row, m from the eye; 0 = right for this height
    double horizon = 0.0;         // last row, m; 0 = where the Earth hides the highest crest
    int columns = 720;            // vertices across, and away
    int rows = 1800;
    /// Slope variance of the waves too short for any map, e.g. those that a buoy does not measure:
    /// light meets them too. Added to that of the waves filtered away.
    double unresolved_slope_variance = 0.0;
};

/// Metres to the horizon of still water from `height` metres above it: sqrt(2 R h).
double horizon_distance(double height);

/// A fan of the sea in front of an eye, dense near and coarse far, to the horizon of a round Earth.
/// `levels` are maps of one sea and time, from the finest resolution to the coarsest, each half the
/// one before: each vertex takes what its distance can show, so that nothing aliases, and its
/// normal is turned to the eye by what the filtered-away waves would have shown of themselves.
/// Needs dx, dy, height, nx, ny, nz, slope_x, slope_y of a tile. Throws Error invalid_value.
Mesh make_horizon_mesh(std::span<const Surface> levels, const View& view);

}  // namespace ocean::io
