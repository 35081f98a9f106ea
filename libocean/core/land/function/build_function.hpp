// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// From a terrain and its noise to its LandFunction: waves or elevation model, gullies, streams,
// shore, detail, in this order.
#pragma once

#include <functional>
#include <memory>
#include <string_view>

#include "ocean/internal/stream_power.hpp"
#include "ocean/internal/terrain_modes.hpp"
#include "ocean/land_function.hpp"
#include "ocean/terrain_model.hpp"

namespace ocean {

/// Receives what is being computed and the share of it that is done, 0 .. 1; may throw to stop.
using LandProgress = std::function<void(std::string_view work, double share)>;

/// The land that streams have carved, kept for terrains that differ only in later steps.
struct CarvedLand {
    TerrainModel of;
    std::shared_ptr<const StreamLand> land;
};

/// The waves of a terrain.
struct LandWaves {
    const TerrainNoise* noise = nullptr;  // null for a terrain with a base
    std::optional<double> rms;            // as set_terrain_modes
    double gain = 1.0;                    // of sqrt(S) to metres
};

/// Returns the function of a shaped terrain. Uses `carved` if it fits, and replaces it if not.
LandFunction build_function(const TerrainModel& terrain, const LandWaves& waves, ThreadPool& pool,
                            CarvedLand& carved, const LandProgress& progress);
/// Returns the function of a tile without gullies, for regions. The tile's own maps are made by
/// transforms of these modes.
LandFunction build_tile_function(const TerrainModel& terrain, const Modes& modes, double offset,
                                 ThreadPool& pool);

/// Returns the samples of a placed land: its rectangle at its own cell.
Domain placed_domain(const TerrainModel& terrain);
/// Returns the shortest wave of the detail [m]; 0 for a land without detail.
double detail_wavelength(const TerrainModel& terrain);
/// Returns the bytes that the function needs while it is built.
std::uint64_t function_bytes(const TerrainModel& terrain);

}  // namespace ocean
