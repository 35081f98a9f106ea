// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The texts of the files in presets/, in the order of CMakeLists.txt. The build fills them in.
#pragma once

#include <span>
#include <string_view>

namespace ocean {

std::span<const std::string_view> sea_preset_files();
std::span<const std::string_view> terrain_preset_files();

}  // namespace ocean
