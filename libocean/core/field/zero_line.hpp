// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Distances to the zero line of a map, finer than its cells.
#pragma once

#include <cstdint>
#include <limits>
#include <span>

#include "grid_lines.hpp"

namespace ocean {

/// The number of passes that zero_line_distance runs.
inline constexpr int kDistancePasses = 5;

/// Writes the distance of each sample to the zero line of `map` [samples], + where the map is above
/// 0, and the index of the sample beside the nearest crossing of the line with the grid. The line
/// is straight within each square of four samples, between points that are linear between two
/// samples (marching squares); where the signs of a square alternate, its land is connected.
/// Distances are exact below 2.5 samples; farther away they may be too long by 0.1 sample where two
/// parts of the line are equally far. The map must have at least one sample on each side of 0.
/// `offsets` is work space of the map's size.
void zero_line_distance(std::span<const float> map, const SampleGrid& grid,
                        std::span<float> offsets, std::span<float> distance,
                        std::span<std::uint32_t> nearest, GridPasses& passes);

}  // namespace ocean
