// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Masks of carved land: channels, wet ground and deposits. StreamLand states their formulas.
#pragma once

#include <cstdint>
#include <span>

#include "ocean/stream_power.hpp"
#include "terrain/stream_tree.hpp"

namespace ocean {

inline constexpr double kMaskWork = 60.0;  // [ns] a cell

/// Writes `channel` from `area`.
void set_channel(const StreamGrid& grid, std::span<const std::uint8_t> directions,
                 StreamLand& land, StreamWork& work);
/// Writes `wetness` and `deposit` from area and height.
void set_wetness_and_deposit(const StreamGrid& grid, const StreamWalk& walk,
                             std::span<const std::uint8_t> directions, StreamLand& land,
                             StreamWork& work);

}  // namespace ocean
