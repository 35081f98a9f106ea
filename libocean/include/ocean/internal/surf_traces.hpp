// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The traces of waves on a coast: constants of the foam of breaking waves and of wet sand, for
// hosts that follow them on samples of their own. Ocean::region() follows them on labels.
#pragma once

namespace ocean {

/// Time in which sand that the swash has wetted dries to 1/e [s].
inline constexpr double kDryingTime = 25.0;

/// Foam of breaking waves hides the share foam^kSurfCoverPower of the water: its lace opens as it
/// fades.
inline constexpr float kSurfCoverPower = 1.35f;

/// Returns how wet the ground is under water of this depth [m], 0 .. 1.
float covered_by(float depth);

}  // namespace ocean
