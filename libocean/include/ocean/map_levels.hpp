// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Maps of one time at halving resolutions, for what lies far away: a coarser map is a sum of fewer
// waves, and its foam and cover are the finer map's mean.
#pragma once

#include <span>
#include <vector>

#include "ocean/ocean.hpp"

namespace ocean {

/// A map of each resolution, the finest first. With foam or cover each must be half the one before.
/// Throws what Ocean::evaluate throws.
std::vector<Surface> map_levels(Ocean& ocean, double time, ChannelSet channels,
                                std::span<const int> resolutions);

/// Fills foam or cover of a map with that of one of twice the resolution: means of each sample and,
/// at half its weight, of those beside it, so that nothing moves. What they become from far away.
void average_channel(Channel channel, const Surface& fine, Surface& coarse);

}  // namespace ocean
