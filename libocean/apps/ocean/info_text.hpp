// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The text of `ocean info`.
#pragma once

#include <string>

#include "ocean/internal/find_crest.hpp"
#include "ocean/ocean.hpp"
#include "ocean/terrain.hpp"
#include "ocean/terrain_model.hpp"

namespace ocean::app {

/// Returns the statistics of a terrain; `name` is its file or preset.
std::string terrain_info_text(const TerrainModel& terrain, const std::string& name,
                              const TerrainState& state);

/// Returns a description of the sea in the quantities of oceanography; `source` is its name.
std::string info_text(const Sea& sea, const std::string& source, const SeaState& state,
                      const FrameCost& cost);

/// The result of --find-crest.
struct FoundCrestText {
    FoundCrest crest;
    double frame = 0.0;  // at its time
    CrestWindow window;
    SeaState state;
};
std::string found_crest_text(const FoundCrestText& found);
/// Returns one JSON object.
std::string found_crest_json(const FoundCrestText& found);

}  // namespace ocean::app
