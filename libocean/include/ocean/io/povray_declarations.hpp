// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// What a POV-Ray scene is told of a sea.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/detail.hpp"
#include "ocean/io/provenance.hpp"
#include "ocean/sea.hpp"
#include "ocean/sea_state.hpp"
#include "ocean/surface.hpp"
#include "ocean/table.hpp"

namespace ocean::io {

/// Of the folders that `ocean povray` writes: ocean.inc refuses any other.
inline constexpr int kPovrayDataVersion = 4;

/// A folder of frames for POV-Ray. References must outlive it.
struct PovrayFolder {
    const Sea& sea;
    const SeaState& state;
    std::string_view format;  // "df3", "mesh2" or "height_field"
    std::vector<int> maps;    // samples a side of each frame's maps, the finest first
    std::vector<int> frames;  // ascending, at least one
    std::string frames_text;  // for people
    std::string_view sea_id;  // of Provenance
    int fine_map = 0;         // samples a side of the map for heights of places; 0 = the finest
};
/// The include file that tells a scene all of that, each parameter by its name:
/// `waves.0.wind_speed` is Ocean_Waves_0_Wind_Speed.
std::string povray_declarations(const PovrayFolder& folder);
/// Returns the line for one parameter of any table: "#declare Ocean_Water_Depth = 20;  // m".
/// Numbers, words and texts as POV-Ray spells them, true and false as they are; what is not set is
/// forgotten, because another folder may have declared it.
std::string povray_parameter_declaration(const ParameterSpec& spec, std::size_t item,
                                         const ParameterValue& value);
/// Returns what a frame says of itself, whatever its format, in names of its subject's prefix:
/// Ocean_Load refuses those of other seas.
std::string povray_frame_declarations(const Provenance& provenance);
/// Whether a text has the declarations of a frame of that sea.
bool declares_sea(std::string_view text, std::string_view sea_id);
/// What Ocean_Material asks of a frame's foam, by cover of the frame's maps, the finest first.
std::string povray_foam_declarations(std::span<const Surface> maps);
std::string povray_detail_declarations(const Detail& detail);

}  // namespace ocean::io
