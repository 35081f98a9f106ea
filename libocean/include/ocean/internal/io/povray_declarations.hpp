// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The declarations of a sea, its frames and its folder for POV-Ray scenes.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/detail.hpp"
#include "ocean/domain.hpp"
#include "ocean/internal/io/provenance.hpp"
#include "ocean/sea.hpp"
#include "ocean/sea_state.hpp"
#include "ocean/surface.hpp"
#include "ocean/table.hpp"
#include "ocean/terrain.hpp"

namespace ocean::io {

/// The version of the folders that `ocean povray` writes; ocean.inc refuses any other.
inline constexpr int kPovrayDataVersion = 4;

/// A folder of frames for POV-Ray. The references must outlive it.
struct PovrayFolder {
    const Sea& sea;
    const SeaState& state;
    std::string_view format;  // "df3", "mesh2" or "height_field"
    std::vector<int> maps;    // samples along a side of each frame's maps, the finest first
    std::vector<int> frames;  // ascending, at least one
    std::string frames_text;  // the frames as readable ranges
    std::string_view sea_id;  // Provenance::id
    int fine_map = 0;         // samples along a side of the fine map; 0 = no fine map
};
/// Returns the include file with the folder and each parameter of the sea by its name:
/// `waves.0.wind_speed` is Ocean_Waves_0_Wind_Speed.
std::string povray_declarations(const PovrayFolder& folder);
/// Returns the line for one parameter of any table: "#declare Ocean_Water_Depth = 20;  // m" with
/// the prefix "Ocean_". Numbers, words and texts have POV-Ray's spelling. A parameter that is not
/// set is undefined explicitly, because another folder may have declared it.
std::string povray_parameter_declaration(const ParameterSpec& spec, std::size_t item,
                                         const ParameterValue& value,
                                         std::string_view prefix = "Ocean_");

/// The version of the folders that `ocean povray` writes for terrains; terrain.inc refuses any
/// other.
inline constexpr int kPovrayTerrainVersion = 2;

/// A folder of a terrain for POV-Ray. The references must outlive it.
struct PovrayTerrain {
    const TerrainModel& terrain;
    const TerrainState& state;
    std::string_view format;  // "df3", "mesh2" or "height_field"
    const Domain& domain;     // of its map
    std::string_view id;      // Provenance::id
};
/// Returns the include file with the folder and each parameter of the terrain by its name:
/// `terrain.beta` is Terrain_Beta.
std::string povray_declarations(const PovrayTerrain& folder);
/// Returns the declarations of the place of a land's map.
std::string povray_land_map_declarations(const Domain& domain);
/// Returns the declarations of the map of a region: its place, which of its sides fade into the
/// open sea, and the id of its frames. bed: of a coast, whose own sides do not fade; null for a
/// region with hulls.
std::string povray_region_declarations(const Domain& domain, const Domain* bed,
                                       std::string_view id);

/// The map of the bed of a sea in the form that terrain.inc reads. The references must outlive it.
struct PovrayBed {
    const Surface& map;  // height, normal and the masks
    std::span<const Channel> masks;
    std::string_view id;
};
/// Returns the include file terrain_parameters.inc of a bed.
std::string povray_bed_parameters(const PovrayBed& bed);
/// Returns the declarations of how many masks a map has, and of the slice of each mask of the
/// table, -1 for one that the map does not have: "#declare Terrain_Beach_Slice_ = 0;".
std::string povray_mask_declarations(std::span<const Channel> masks, std::string_view prefix);
/// Returns the text beside the map of a bed.
std::string povray_bed_words(const PovrayBed& bed);
/// Returns the declarations of a frame of any format, in names with the prefix of the frame's
/// subject. Ocean_Load reads them to refuse frames of other seas.
std::string povray_frame_declarations(const Provenance& provenance);
/// Returns true if a text has the declarations of a frame of the sea `sea_id`.
bool declares_sea(std::string_view text, std::string_view sea_id);
/// Returns the foam's thickness for Ocean_Material, from the cover of a frame's maps, the finest
/// first; "" for maps without cover, and for a map that exists once.
std::string povray_foam_declarations(std::span<const Surface> maps);
/// Returns the bands of the slope tiles for Ocean_Material.
std::string povray_detail_declarations(const Detail& detail);

}  // namespace ocean::io
