// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The argument of `ocean-preview`: a sea or a terrain, recognised by the file.
#pragma once

#include <variant>

#include "ocean/internal/preview/picture.hpp"
#include "ocean/sea.hpp"
#include "ocean/terrain_model.hpp"
#include "sea_argument.hpp"

namespace ocean::app {

/// A resolved and validated sea or terrain.
using OpenedScene = std::variant<Sea, TerrainModel>;

preview::SceneKind kind_of(const OpenedScene& scene);
/// Returns the argument and --set as options.
OptionGroup scene_options(SeaArgument& argument);
/// Returns the sea or the terrain that an argument names. Throws Error.
OpenedScene open_scene(const SeaArgument& argument);
/// Returns "sea" or "terrain".
const char* noun_of(preview::SceneKind kind);

}  // namespace ocean::app
