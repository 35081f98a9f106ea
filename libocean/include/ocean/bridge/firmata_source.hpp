// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Arduinos with StandardFirmata at a serial line: inputs a0 .. a15 (0 .. 1023), d0 .. d127 (0 or
// 1); outputs o0 .. o127 (0 or 1) and pwm0 .. pwm127 (0 .. 255); of them those that the map names.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "ocean/bridge/map_file.hpp"
#include "ocean/bridge/source.hpp"

namespace ocean::bridge {

/// Of such a board named `board`.
std::vector<Channel> firmata_channels(const std::string& board, const FirmataDevice& device);

/// The board may come and go at any time. What an output was told holds for a board that is not
/// there, and is sent to it when it comes; at the end all outputs are put out.
std::unique_ptr<Source> make_firmata_source(const std::string& id, const FirmataDevice& device);

}  // namespace ocean::bridge
