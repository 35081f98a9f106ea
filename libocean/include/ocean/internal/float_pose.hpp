// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The pose of a floating body: the plane that fits the displayed surface below it best. For boats
// and buoys that follow the waves in a picture; not a computation of forces.
#pragma once

#include <functional>
#include <span>

#include "ocean/internal/surface_query.hpp"
#include "ocean/query.hpp"

namespace ocean {

/// Throws Error invalid_value for a number that is not finite and for a length or width outside 0
/// .. 1e5 m.
void require_body(const FloatBody& body);

/// Returns the pose on the least-squares plane through the surface over the rectangle. The samples
/// lie as close as the displayed map's, but at most 64 along a side, too few for the shortest waves
/// below a longer body. Along a side shorter than one sample the slope is the surface's slope at
/// the point, so that a small body gets the surface's normal. Throws as require_body.
FloatPose float_pose(const SurfaceQuery& query, const FloatBody& body, ThreadPool& pool);

/// Writes a sample of some surface for each point.
using SampleSurface =
    std::function<void(std::span<const WorldPoint> points, std::span<QuerySample> samples)>;
/// Returns the pose on any surface, whose samples lie `spacing` [m] apart.
FloatPose float_pose(const SampleSurface& surface, double spacing, const FloatBody& body);

}  // namespace ocean
