// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A terrain as a Subject, and the way back from a Subject to its terrain.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "ocean/subject.hpp"
#include "ocean/terrain_model.hpp"

namespace ocean {

class Terrain;
struct Region;

/// How often a tile is repeated to the east and to the north.
struct TerrainTiles {
    int x = 1;
    int y = 1;

    bool operator==(const TerrainTiles&) const = default;
};
inline constexpr int kMaxTerrainTiles = 64;

/// Returns the samples of a region. Throws Error invalid_value as domain_of(region), and for a
/// region that does not lie within a placed land.
Domain domain_of(const TerrainModel& terrain, const Region& region);

/// Returns a region of a valid, resolved terrain as a subject.
std::unique_ptr<Subject> make_region_subject(TerrainModel terrain, const Region& region);
/// Returns a valid, resolved terrain as a subject. The domain of its maps holds `tiles` tiles; a
/// resolution counts the samples of one tile.
std::unique_ptr<Subject> make_subject(TerrainModel terrain, TerrainTiles tiles = {});
/// Returns the terrain or region that the text() of its subject describes. `name` stands for a path
/// in messages. Throws Error as parse_terrain.
std::unique_ptr<Subject> parse_terrain_subject(std::string_view text, const std::string& name);

/// Returns the terrain of a subject, or null for a subject of another kind.
const TerrainModel* find_terrain(const Subject& subject);
/// Returns the Terrain that makes these maps. Throws Error unsupported for maps of another kind.
Terrain& terrain_of(SubjectMaps& maps);

}  // namespace ocean
