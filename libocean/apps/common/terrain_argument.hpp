// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The argument TERRAIN and the options --set, --region and --cell of the commands for terrains, and
// the resolved and validated terrain that they name.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "command.hpp"
#include "ocean/terrain.hpp"
#include "ocean/terrain_subject.hpp"

namespace ocean::app {

struct TerrainArgument {
    std::string source;                    // a terrain file, a baked file, or preset:NAME
    std::vector<std::string> assignments;  // name=value, in order
};

/// Returns the options TERRAIN and --set.
OptionGroup terrain_options(TerrainArgument& argument, bool required = kRequired);

/// Returns the terrain. Throws Error.
Terrain open_terrain(const TerrainArgument& argument);

/// The options --region and --cell as they were typed; "" = not given.
struct RegionArgument {
    std::string region, cell;
};
/// Returns the options --region and --cell.
std::vector<Option> region_options(RegionArgument& argument);
/// Returns the region that is typed, if one is. Throws Error invalid_value.
std::optional<TerrainRegion> parse_region(const RegionArgument& argument);

/// Returns true if a source names a terrain: a preset of one, a baked file of one, or a file with
/// [terrain]. False for everything else, also for what cannot be read. Standard input and pipes are
/// not looked into.
bool names_terrain(const std::string& source);
/// Throws Error not_found, with the nearest names, for "preset:NAME" that is neither a sea's nor a
/// terrain's.
void refuse_unknown_preset(const std::string& source);

}  // namespace ocean::app
