// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ocean/internal/modes.hpp"
#include "ocean/parameters.hpp"

namespace ocean {

/// Returns the Jacobian threshold at which mean_whitecap is `wanted`, at most `highest`; the lowest
/// float if `wanted` is 0 or the water is never compressed.
double threshold_of_mean(const GradientCovariance& covariance, const SurfaceSettings& settings,
                         double wanted, double highest);

}  // namespace ocean
