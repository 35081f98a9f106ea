// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The points of `ocean query` and `ocean gauge` over the bed of a sea.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "ocean/query.hpp"
#include "ocean/sea.hpp"

namespace ocean::app {

/// Returns a sentence for points that lie beyond the bed of a sea, and, if they are `in_water`, for
/// those that lie in its ground. Empty for an open sea.
std::vector<std::string> bed_point_warnings(const Sea& sea, std::span<const WaterPoint> points,
                                            bool in_water);

}  // namespace ocean::app
