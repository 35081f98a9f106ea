// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The sentences of a sea's state.
#pragma once

#include "ocean/sea_state.hpp"

namespace ocean {

/// Adds the warnings that users should read before a bake. `flat`: the spectrum has no energy.
void add_warnings(const Parameters& parameters, bool flat, SeaState& state);
/// Adds a warning if the folded_share exceeds any natural sea's.
void add_folding_warning(const SurfaceSettings& surface, SeaState& state);

}  // namespace ocean
