// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The variance of a fitted tile: the mean over all seeds, the variance of one seed, and the seeds
// whose tile has a given variance. Rings say little about it: most of it is in the longest waves,
// and a tile has few of them.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "ocean/terrain_model.hpp"
#include "ocean/thread_pool.hpp"

namespace ocean {

/// Returns the sum of S dkx dky over the waves of the tile, the mean variance of all seeds; [m^2]
/// where the law is absolute (see TerrainLaw::is_absolute), else relative.
double law_variance(const TerrainModel& terrain);

/// Returns the variance of the tile of terrain.seed, in the unit of law_variance.
double seed_variance(const TerrainModel& terrain, ThreadPool& pool);

/// Returns the `count` seeds of the first kSeedsTried whose tiles are closest to a variance, the
/// closest first. `variance` has the unit of law_variance.
std::vector<std::uint32_t> seeds_of_variance(const TerrainModel& terrain, double variance,
                                             int count, ThreadPool& pool);
inline constexpr std::uint32_t kSeedsTried = 512;

/// Returns the ratio of two variances of a part of `samples` samples of the tile: the variance of
/// its least-squares plane over the variance about that plane, each averaged over all seeds.
double expected_tilt(const TerrainModel& terrain, const std::array<int, 2>& samples);

}  // namespace ocean
