// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Pieces of a sea file's text, shared by the writer and the presets.
#pragma once

#include <functional>
#include <string>

#include "ocean/parameter_table.hpp"

namespace ocean {

/// A chosen parameter's line, "resolution = 512\n"; empty to leave it out.
using LineOfParameter = std::function<std::string(const ParameterRef&)>;

/// "libocean = 1", then each section of the table that has a line, each wave system in turn.
/// `after_wave` gives what follows the keys of a wave system.
std::string sea_file_text(const Parameters& parameters, const LineOfParameter& line,
                          const std::function<std::string(const WaveSystem&)>& after_wave);

/// "key = value"; empty for an optional that is unset.
std::string parameter_line(const Parameters& parameters, const ParameterRef& ref);

}  // namespace ocean
