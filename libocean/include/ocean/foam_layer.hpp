// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// What the foam of a moment is laid over: how the foam's past, which foam.hpp follows, comes into
// the maps of one time.
#pragma once

namespace ocean {

/// What is left of earlier foam: foam = max(W, fade * map), and 0 where that is below `least`. The
/// share that it covers is foam^cover_power.
struct FoamLayer {
    const float* map = nullptr;  // null: nothing
    float fade = 0.0f;
    float least = 0.0f;
    float cover_power = 1.0f;
};

}  // namespace ocean
