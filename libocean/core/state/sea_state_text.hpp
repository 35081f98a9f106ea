// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The sentences of a sea's state.
#pragma once

#include "ocean/sea_state.hpp"

namespace ocean {

/// What of a state people should know before they bake. `flat`: no energy is asked for.
void add_warnings(const Parameters& parameters, bool flat, SeaState& state);
/// If its folded_share is more than that of any natural sea.
void add_folding_warning(const SurfaceSettings& surface, SeaState& state);

}  // namespace ocean
