// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Statistics of heights on a grid that a spectrum does not hold, or holds only for Gaussian land.
#pragma once

#include <span>

#include "ocean/domain.hpp"
#include "ocean/internal/elevation.hpp"
#include "ocean/internal/terrain_fit.hpp"

namespace ocean {

/// Returns the statistics of a row-major array of heights [m] on a domain that exists once.
Relief relief_of(const Domain& domain, std::span<const float> heights);

/// Returns the relief of a model. For a model with more than `max_side` samples along a side it is
/// the mean of nine parts of that size, because a longer piece of land is higher.
Relief relief_of_parts(const ElevationModel& bed, int max_side);

/// Adds a share of the statistics to a mean. Leaves out the direction, because angles have no such
/// mean.
void add(Relief& sum, const Relief& one, double share);

}  // namespace ocean
