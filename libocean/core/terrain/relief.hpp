// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Statistics of heights on a grid that a spectrum does not hold, or holds only for Gaussian land.
#pragma once

#include <span>

#include "ocean/domain.hpp"
#include "ocean/terrain_fit.hpp"

namespace ocean {

/// Returns the statistics of a row-major array of heights [m] on a domain that exists once.
Relief relief_of(const Domain& domain, std::span<const float> heights);

}  // namespace ocean
