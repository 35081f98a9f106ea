// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The conditions that the crests of a sea set to one part of its waves: rows with their targets and
// covariances, ready to be solved.
#pragma once

#include <cstddef>
#include <vector>

#include "waves/crests/crest_rows.hpp"
#include "waves/crests/crest_waves.hpp"
#include "waves/crests/dependent_rows.hpp"

namespace ocean {

struct CrestConditions {
    CrestRows rows;
    RowSums sums;
    std::vector<double> targets;  // the values of the rows in the sea with its crests
    /// The number of rows that define the crests, the first ones; the others follow from them.
    std::size_t required = 0;
};

/// Returns the conditions of the long waves: of each crest its height, slopes, rise and
/// displacement, then the heights around it. Throws Error invalid_value for a crest that these
/// waves cannot make.
CrestConditions long_conditions(const CrestWaves& waves);
/// Returns the conditions of the short waves: height and displacement are 0 at each crest.
CrestConditions short_conditions(const CrestWaves& waves);

}  // namespace ocean
