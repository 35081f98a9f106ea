// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Probes, a picture, a list or a sequence of pictures, without a window.
#pragma once

#include <string>
#include <vector>

#include "command.hpp"
#include "picture_list.hpp"
#include "preview_options.hpp"
#include "scene_argument.hpp"

namespace ocean::app {

/// Returns the name of a sea or a terrain without its folder and ending: "storm" of
/// "seas/storm.toml" and of "preset:storm".
std::string stem_of(const std::string& source);

/// Prints the requested probes, draws the requested pictures, and prints the budget. Throws Error.
void run_offscreen(const PreviewOptions& options, const std::vector<ListedPicture>& pictures,
                   const OpenedScene& scene, const std::string& source, const Context& context);

}  // namespace ocean::app
