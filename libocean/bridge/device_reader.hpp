// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Reads one [[device]] of a control map.
#pragma once

#include <string>
#include <vector>

#include "ocean/internal/bridge/device.hpp"
#include "ocean/internal/toml_sections.hpp"

namespace ocean::bridge {

/// Returns the board of the section. `before` are the boards of the sections above it, whose ids
/// this board may not have. Throws Error bad_file that begins with `file` and a line.
DeviceRule read_device(const TomlSection& section, const std::string& file,
                       const std::vector<DeviceRule>& before);

}  // namespace ocean::bridge
