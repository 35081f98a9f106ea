// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Finds a way to an outlet for every cell of a surface with hollows, by the priority flood: water
// rises from the outlets, the lowest cell first [Barnes 2014].
#pragma once

#include <cstdint>
#include <span>

#include "land/streams/stream_grid.hpp"
#include "land/streams/stream_work.hpp"

namespace ocean {

/// Values of a cell's byte besides the direction of its receiver.
inline constexpr std::uint8_t kOutlet = 8;
inline constexpr std::uint8_t kFlooded = 0x10;  // bit: the direction is the flood's, and stays
inline constexpr std::uint8_t kUnseen = 0xFF;
inline constexpr std::uint8_t kDirectionBits = 0x07;

/// How the flood treats hollows.
enum class FloodTo {
    carve,  // hollows become level; their ways out follow their valleys, from the deepest place up
    drain,  // hollows rise strictly from their outlet: every cell has a lower neighbour
};

inline constexpr double kFloodWork = 30.0;  // [ns] a cell

/// Raises the heights of hollows and writes into each kUnseen cell the direction from which the
/// flood came, with kFlooded if the flood raised the cell. Outlets are kOutlet and keep their
/// heights. Requires an outlet. Ties go by index. A chain of directions never rises and ends in an
/// outlet.
void flood(const StreamGrid& grid, FloodTo to, std::span<float> heights,
           std::span<std::uint8_t> directions, StreamWork& work);

}  // namespace ocean
