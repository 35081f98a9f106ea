// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// `ocean info` of a terrain, for people.
#pragma once

#include <string>

#include "ocean/terrain.hpp"
#include "ocean/terrain_model.hpp"

namespace ocean::app {

/// Returns the statistics of a terrain; `name` is its file or preset.
std::string terrain_info_text(const TerrainModel& terrain, const std::string& name,
                              const TerrainState& state);

}  // namespace ocean::app
