// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The argument TERRAIN and the option --set of the commands for terrains, and the resolved and
// validated terrain that they name.
#pragma once

#include <string>
#include <vector>

#include "command.hpp"
#include "ocean/terrain_model.hpp"

namespace ocean::app {

struct TerrainArgument {
    std::string source;                    // a terrain file, a baked file, or preset:NAME
    std::vector<std::string> assignments;  // name=value, in order
};

/// Returns the options TERRAIN and --set.
OptionGroup terrain_options(TerrainArgument& argument, bool required = kRequired);

/// Returns the terrain. Throws Error.
TerrainModel open_terrain(const TerrainArgument& argument);

/// Returns true if a source names a terrain: a preset of one, a baked file of one, or a file with
/// [terrain]. False for everything else, also for what cannot be read. Standard input and pipes are
/// not looked into.
bool names_terrain(const std::string& source);
/// Throws Error not_found, with the nearest names, for "preset:NAME" that is neither a sea's nor a
/// terrain's.
void refuse_unknown_preset(const std::string& source);

}  // namespace ocean::app
