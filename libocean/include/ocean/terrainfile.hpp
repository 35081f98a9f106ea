// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Terrain files: strict reading, writing that round-trips, and presets; and a terrain as a Subject,
// with the way back from a Subject to its terrain.
//
//     TerrainModel hills = read_terrain("hills.toml");
//     const Preset& preset = find_terrain_preset("bay_island");
//     TerrainModel island = parse_terrain(preset.toml, preset.name, "");
//     std::string text = write_terrain(hills);  // needs no other file
//     std::unique_ptr<Subject> subject = make_subject(hills, {.x = 2, .y = 3});  // for a bake
//     const TerrainModel* back = find_terrain(*subject);
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/seafile.hpp"
#include "ocean/subject.hpp"
#include "ocean/terrain_model.hpp"

namespace ocean {

class Terrain;
struct Region;

/// Reads a terrain file. A relative `measured` in it is relative to the terrain file. Throws Error
/// with "PATH:LINE: terrain.key = VALUE: FAULT; allowed: RANGE".
TerrainModel read_terrain(const std::string& path);
/// Reads the text of a terrain file. `name` stands for the path in messages; a relative `measured`
/// is relative to base_dir (empty: the current directory). Throws as read_terrain.
TerrainModel parse_terrain(std::string_view toml, const std::string& name,
                           const std::string& base_dir);
/// Reads the rings that `measured` names and the elevation model that `base` names, if the terrain
/// has not read them yet. Throws Error of the parameter that names the file.
void resolve_files(TerrainModel& terrain, const std::string& base_dir);
/// Returns the files that a terrain names, as its own file spells them.
std::vector<std::string> named_files(const TerrainModel& terrain);
/// Returns the resolved terrain as text, with the rings of `measured` inlined as
/// [terrain.measured_rings] and a base of at most 1 MB as [terrain.base_heights], which a reader
/// prefers to the files; for a larger base the text has the hash alone.
/// parse_terrain(write_terrain(t)) gives the same terrain bit by bit. Throws Error invalid_value
/// for a terrain that is not valid.
std::string write_terrain(const TerrainModel& terrain);

/// Returns the terrain presets, in the order in which they are listed.
std::span<const Preset> terrain_presets();
/// Returns the terrain preset of that name. Throws Error not_found naming the nearest.
const Preset& find_terrain_preset(std::string_view name);

// ---- Terrains as subjects

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
