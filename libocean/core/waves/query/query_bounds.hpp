// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Bounds of a query, known before any point is evaluated: the displacement of labels, and the error
// of the answers.
#pragma once

#include "ocean/internal/modes.hpp"
#include "ocean/thread_pool.hpp"

namespace ocean {

/// Bounds from sums over the modes, valid at all points and times.
struct QueryBounds {
    /// Max displacement of a label at choppiness 1 [m]: eight times the rms of the displacement,
    /// which Gaussian waves exceed at one place in 10^13, or the sum of all amplitudes if that is
    /// less.
    double farthest;
    /// rms height error [m]: waves that a map of `band` samples does not hold and, unless the
    /// answers are exact, the aliases of the others on the spline.
    double error;
};

/// Sums over the modes. band: samples of the map whose waves are shown. spline: samples of the
/// interpolated map, unless the answers are exact.
QueryBounds query_bounds(const Modes& modes, int band, int spline, bool exact, ThreadPool& pool);

}  // namespace ocean
