// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Maps of one time at halving resolutions, for distant water: a coarser map is the sum of fewer
// waves, and its foam and cover are means of the finer map.
#pragma once

#include <span>
#include <vector>

#include "ocean/ocean.hpp"

namespace ocean {

/// Returns a map of each resolution, ordered from the finest. With foam or cover, each resolution
/// must be half the previous one. Throws as Ocean::evaluate.
std::vector<Surface> map_levels(Ocean& ocean, double time, ChannelSet channels,
                                std::span<const int> resolutions);

/// Fills foam or cover of `coarse` with means of `fine`, which has twice the resolution: means over
/// a sample and, at half its weight, its neighbours, so that nothing shifts.
void average_channel(Channel channel, const Surface& fine, Surface& coarse);

}  // namespace ocean
