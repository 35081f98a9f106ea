// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "scene_argument.hpp"

#include "terrain_argument.hpp"

namespace ocean::app {

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
    refuse_unknown_preset(argument.source);
    if (names_terrain(argument.source)) {
        return open_terrain({argument.source, argument.assignments});
    }
    return open_sea(argument);
}

const char* noun_of(preview::SceneKind kind) {
    return kind == preview::SceneKind::sea ? "sea" : "terrain";
}

}  // namespace ocean::app
