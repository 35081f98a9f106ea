// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// How a floating body lies on the sea: the plane that fits the shown surface best below it. For
// things that follow the waves, a boat or a buoy in a picture; not a calculation of forces.
#pragma once

#include "ocean/query.hpp"

namespace ocean {

/// The rectangle that a body covers.
struct FloatBody {
    double x, y;     // m, its centre
    double heading;  // degrees counter-clockwise from +x (east): where its bow points to
    double length;   // m, along the heading
    double width;    // m
};

struct FloatPose {
    double position[3];  // m: the body's x and y, and the height of the plane there
    double up[3];        // unit vectors of the tilted body
    double forward[3];
    double pitch;  // degrees, bow up
    double roll;   // degrees, port side (left of the heading) up
};

/// Throws Error invalid_value for a number that is not finite, a length or width that is negative
/// or beyond 1e5 m.
void require_body(const FloatBody& body);

/// The least-squares plane through the surface over the rectangle, on samples as close as those of
/// the shown map, at most 64 a side, which are too few for the shortest waves below a longer body.
/// Along a side shorter than one sample the slope is that of the surface itself, so that a small
/// body takes the surface's normal. Throws as require_body.
FloatPose float_pose(const SurfaceQuery& query, const FloatBody& body, ThreadPool& pool);

}  // namespace ocean
