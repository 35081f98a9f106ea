// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Earlier foam: how the past of the foam, which foam.hpp follows, enters the maps of one time.
#pragma once

namespace ocean {

/// The faded earlier foam of a map: foam = foam_with_whitecap(W, fade * map, alone) of
/// shaders/wave/foam_cover.glsl, set to 0 below `cutoff`. Foam covers the share foam^cover_power of
/// the water. The map of a tick that is to be followed further writes that foam to `kept` and shows
/// foam_with_whitecap(W, kept, alone), as any later map would.
struct FoamLayer {
    const float* map = nullptr;  // null: no earlier foam
    float fade = 0.0f;
    float cutoff = 0.0f;
    float cover_power = 1.0f;
    float alone = 1.0f;     // part of a whitecap where there is no earlier foam
    float* kept = nullptr;  // null: the foam is not kept
};

}  // namespace ocean
