// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The summary of a hull and its wake for users.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "ocean/parameters.hpp"
#include "ocean/sea_state.hpp"

namespace ocean {

class ThreadPool;

/// Returns the summary of a valid hull, which computes its wake at one time. loop_period: of the
/// sea.
HullSummary hull_summary(const Hull& hull, const Water& water, double loop_period,
                         ThreadPool& pool);
/// Returns sentences on waves that are too steep for theory, or too short for the samples of the
/// wake. `name`: of the hull, "hulls.0".
std::vector<std::string> wake_warnings(const HullSummary& hull, std::string_view name);

}  // namespace ocean
