// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// ocean_terrain, the handle of a terrain.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "handle.hpp"
#include "libocean.h"
#include "ocean/internal/land_mesh.hpp"
#include "ocean/surface.hpp"
#include "ocean/terrain.hpp"

namespace ocean::capi {

/// The word for the handle in messages.

/// A mesh whose counts the host knows.
struct CountedMesh {
    QuadtreeSettings settings;
    std::array<double, 3> eye{};
    double ground = 0.0;
    LandMesh mesh;
};

}  // namespace ocean::capi

struct ocean_terrain : ocean::capi::Handle {
    static constexpr const char* kName = "terrain";
    ocean_terrain(ocean::TerrainModel terrain, ocean::TerrainOptions opened_with,
                  std::string folder)
        : options(std::move(opened_with)),
          base_dir(std::move(folder)),
          land(std::make_unique<ocean::Terrain>(std::move(terrain), options)) {}
    ocean_terrain(const ocean_terrain& built, ocean::TerrainOptions opened_with)
        : options(std::move(opened_with)),
          base_dir(built.base_dir),
          land(std::make_unique<ocean::Terrain>(*built.land, options)) {}

    ocean::TerrainOptions options;
    std::string base_dir;                  // where a relative `measured` starts
    std::unique_ptr<ocean::Terrain> land;  // readers may make it build what they ask for
    std::vector<ocean::MapOutput> map_outputs;
    /// That of the last call for counts, until it is copied.
    std::optional<ocean::capi::CountedMesh> mesh;
};
