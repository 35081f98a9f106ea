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

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/seafile.hpp"
#include "ocean/terrain_model.hpp"

namespace ocean {

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

}  // namespace ocean
