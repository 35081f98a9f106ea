// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Maps of waves continued onto the land, where the swash runs up.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "coast/bed/bed_grid.hpp"
#include "energy_march.hpp"
#include "ocean/thread_pool.hpp"
#include "shore_delays.hpp"

namespace ocean {

/// Where the bed is higher than this, the waves are as over the nearest water [m].
inline constexpr float kLastWater = -0.4f;
/// The share of their change from the nearest water that delays keep on land: all of the swash runs
/// up nearly at once. Crests that crossed a flat beach one after the other would leave pools
/// between them, and the line of the water would leap from one to the next.
inline constexpr double kChangeOnLand = 0.03;

/// Returns for each sample of the bed the index of the nearest water, a bed at most kLastWater
/// high: its own index in water, and everywhere if all samples are water, or all are land.
std::vector<std::uint32_t> nearest_water(const BedGrid& bed_height, ThreadPool& pool);

/// Replaces x + D and P on land by the values at the nearest water plus kChangeOnLand of the change
/// from there. Directions stay. `maps` and `bed_height` have the same grid.
void continue_onto_land(DelayMaps& maps, const BedGrid& bed_height,
                        std::span<const std::uint32_t> nearest);

/// Replaces the energy on land by the energy at the nearest water. The arriving energy stays the
/// same; heights shrink by the ratio of the min depth that waves feel to the depth at that water,
/// as in saturated surf.
void continue_onto_land(EnergyMaps& maps, const BedGrid& bed_height, ThreadPool& pool);

}  // namespace ocean
