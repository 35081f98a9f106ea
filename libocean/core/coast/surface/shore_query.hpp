// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The surface of a sea over its bed at points of the world: the label that is displayed at each
// point, and the surface there.
#pragma once

#include <span>

#include "coast/surface/shore_surface.hpp"
#include "ocean/query.hpp"

namespace ocean {

class ThreadPool;

/// Writes one sample for each point; foam is 0. The bits are the same for any number of threads.
/// `labelled` receives the surface at the labels found. Points must be finite. exact: see
/// ShoreSurface::read.
void query_shore(const ShoreSurface& surface, std::span<const WorldPoint> points,
                 std::span<QuerySample> samples, std::span<ShorePoint> labelled,
                 const ShoreSums* exact, ThreadPool& pool);

/// Throws Error unsupported for a query of a coarser map's waves, which a coast cannot select, and
/// invalid_value for a `refine` that a map of the grid does not allow.
void require_query_of_coast(const Grid& grid, const QueryOptions& options);

}  // namespace ocean
