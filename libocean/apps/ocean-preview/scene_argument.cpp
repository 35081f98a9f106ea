// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "scene_argument.hpp"

#include <algorithm>
#include <iterator>

namespace ocean::app {

OptionGroup scene_options(SubjectArgument& argument) {
    return {"Scene",
            {{"SEA", &argument.source, "",
              "A sea file or a terrain file, - for a sea on standard input, an EXR file that was "
              "baked from one, or preset:NAME",
              kRequired},
             {"--set", &argument.assignments, "NAME=VALUE",
              "Change a parameter, such as wind_speed=12 or waves.1.fetch=50000 of a sea, beta=2.2 "
              "of a terrain; may be repeated"}}};
}

OpenedScene open_scene(const SubjectArgument& argument) {
    const std::vector<const SceneRow*>& rows = scene_rows();
    const auto names_it = [&](const SceneRow* row) { return row->is_named(argument.source); };
    return (*std::find_if(rows.rbegin(), rows.rend(), names_it))->open(argument);
}

std::vector<std::string> all_view_names(const SceneRow& row) {
    std::vector<std::string> names = row.views();
    names.insert(names.end(), row.stages.begin(), row.stages.end());
    return names;
}

std::vector<std::string> all_view_names() {
    std::vector<std::string> names;
    for (const SceneRow* const row : scene_rows()) {
        std::ranges::copy_if(
            all_view_names(*row), std::back_inserter(names),
            [&](const std::string& name) { return std::ranges::find(names, name) == names.end(); });
    }
    return names;
}

bool is_stage_picture(const std::string& view) {
    return std::ranges::any_of(scene_rows(), [&](const SceneRow* row) {
        return std::ranges::find(row->stages, view) != row->stages.end();
    });
}

}  // namespace ocean::app
