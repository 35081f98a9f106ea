// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The argument of `ocean-preview`: a sea or a terrain, recognised by the file.
#pragma once

#include "scene.hpp"
#include "subject_argument.hpp"

namespace ocean::app {

/// Returns the argument and --set as options.
OptionGroup scene_options(SubjectArgument& argument);
/// Returns the subject that an argument names. Throws Error.
OpenedScene open_scene(const SubjectArgument& argument);

/// Returns the views that a person can choose: those of the renderer, then the stages.
std::vector<std::string> all_view_names(const SceneRow& row);
/// Returns the names of all views of all rows, each once.
std::vector<std::string> all_view_names();
/// Returns true for a stage of any row.
bool is_stage_picture(const std::string& view);

}  // namespace ocean::app
