// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "scene_argument.hpp"

#include <algorithm>
#include <span>
#include <string_view>
#include <vector>

#include "ocean/error.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/nearest_name.hpp"
#include "ocean/seafile.hpp"
#include "ocean/terrainfile.hpp"
#include "source_text.hpp"
#include "terrain_argument.hpp"

namespace ocean::app {
namespace {

/// Throws Error not_found that names the nearest presets of both kinds.
void require_preset(const std::string& name) {
    std::vector<std::string_view> names;
    for (const std::span<const Preset> list : {presets(), terrain_presets()}) {
        for (const Preset& preset : list) names.push_back(preset.name);
    }
    if (std::ranges::find(names, name) != names.end()) return;
    throw Error(ErrorKind::not_found, "no preset is called '" + text::printable(name) + "'" +
                                          did_you_mean(name, names) +
                                          "; `ocean presets` lists those of seas and terrains");
}

}  // namespace

preview::SceneKind kind_of(const OpenedScene& scene) {
    return std::holds_alternative<Sea>(scene) ? preview::SceneKind::sea : preview::SceneKind::land;
}

OptionGroup scene_options(SeaArgument& argument) {
    return {"Scene",
            {{"SEA", &argument.source, "",
              "A sea file or a terrain file, - for a sea on standard input, an EXR file that was "
              "baked from one, or preset:NAME",
              kRequired},
             {"--set", &argument.assignments, "NAME=VALUE",
              "Change a parameter, such as wind_speed=12 or waves.1.fetch=50000 of a sea, beta=2.2 "
              "of a terrain; may be repeated"}}};
}

OpenedScene open_scene(const SeaArgument& argument) {
    if (argument.source.starts_with(kPresetPrefix)) {
        require_preset(argument.source.substr(kPresetPrefix.size()));
    }
    if (names_terrain(argument.source)) {
        return open_terrain({argument.source, argument.assignments});
    }
    return open_sea(argument);
}

const char* noun_of(preview::SceneKind kind) {
    return kind == preview::SceneKind::sea ? "sea" : "terrain";
}

}  // namespace ocean::app
