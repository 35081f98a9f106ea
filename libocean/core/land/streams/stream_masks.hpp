// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Masks of carved land: channels, wet ground and deposits. StreamLand states their formulas.
#pragma once

#include <cstdint>
#include <span>

#include "land/streams/stream_tree.hpp"

namespace ocean {

inline constexpr double kMaskWork = 60.0;  // [ns] a cell, with the walk

/// Returns the share of a channel in a cell, from the drainage area [m2].
float channel_of(float area);
void set_wetness(const StreamGrid& grid, std::span<const std::uint8_t> directions,
                 std::span<const float> area, std::span<const float> height,
                 std::span<float> wetness, StreamWork& work);
/// Replaces the heights of the bed by the mask of deposits on it.
void set_deposit(const StreamGrid& grid, const StreamWalk& walk,
                 std::span<const std::uint8_t> directions, std::span<const float> area,
                 std::span<const float> height, std::span<float> bed, StreamWork& work);

}  // namespace ocean
