// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A [[device]] of the map: which keys there are is the driver's business.
#pragma once

#include <string>
#include <vector>

#include "ocean/bridge/map_file.hpp"
#include "ocean/internal/toml_sections.hpp"

namespace ocean::bridge {

/// `before` are the devices above it in the file. Throws Error bad_file "FILE:LINE: ...".
DeviceRule read_device(const TomlSection& section, const std::string& file,
                       const std::vector<DeviceRule>& before);

}  // namespace ocean::bridge
