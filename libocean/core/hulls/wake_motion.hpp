// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The motion of the water below a wake: of its waves, as those of the open sea move it. The water
// that the hull itself pushes aside is left out.
#pragma once

#include <span>

#include "ocean/parameters.hpp"
#include "ocean/query.hpp"

namespace ocean {

class ThreadPool;
class Wake;

/// Adds the motion below a wake at its time to those at fixed points; nothing beyond its square.
/// exact: from sums over all waves instead of maps. Throws Error invalid_value for a height that is
/// no number.
void add_wake_motion(const Wake& wake, const Water& water, bool exact,
                     std::span<const WaterPoint> points, std::span<WaterMotion> motions,
                     ThreadPool& pool);

}  // namespace ocean
