// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Bounds that a query knows of a sea before it evaluates any point: the displacement of labels, and
// the error of its answers.
#pragma once

#include "ocean/modes.hpp"
#include "ocean/thread_pool.hpp"

namespace ocean {

/// Bounds from sums over the modes, valid at all points and times.
struct QueryBounds {
    /// No label is displaced farther than this at choppiness 1, m: eight times the rms of the
    /// displacement, which of Gaussian waves one place in 10^13 is, or the sum of all amplitudes,
    /// if that is less.
    double farthest;
    /// rms of the height that answers lack, m: of the waves that a map of `band` samples does not
    /// hold, and unless the answers are exact of the aliases of the others on the spline.
    double error;
};

/// Sums over the modes. band: samples of the map whose waves are shown. spline: samples of the map
/// between which the answers interpolate, unless they are exact.
QueryBounds query_bounds(const Modes& modes, int band, int spline, bool exact, ThreadPool& pool);

}  // namespace ocean
