// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Output paths of all commands: their folders, and files that are no bake.
#pragma once

#include <string>
#include <string_view>

namespace ocean::app {

/// Makes `folder` and those above it; "" is the current one. Throws Error output.
void make_folder(const std::string& folder);
/// The whole file or nothing, its folder made first. Throws Error output.
void write_output(const std::string& path, std::string_view bytes);

}  // namespace ocean::app
