// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Soil creep between channels: diffusion of heights, which makes crests round.
#pragma once

#include <span>

#include "land/streams/stream_grid.hpp"
#include "land/streams/stream_work.hpp"

namespace ocean {

inline constexpr double kCreepWork = 40.0;  // [ns] a cell

/// Lets heights creep: dz/ds = w laplacian(z) to s = reach^2 / 4, so that a ridge spreads to a
/// standard deviation of reach / sqrt(2) [m]; w = 1 - channel, and 0 in outlets. No water or
/// ground crosses the border of the grid. Implicit steps along one axis after the other are stable
/// for any cell and make no new extremes.
void creep(const StreamGrid& grid, double reach, std::span<const float> channel,
           std::span<const std::uint8_t> directions, std::span<float> heights, StreamWork& work);

}  // namespace ocean
