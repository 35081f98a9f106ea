// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Values in TOML's spelling: the right-hand sides of "key =" in sea files and presets.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/table.hpp"

namespace ocean {

/// Returns a basic string. Throws Error invalid_value for text that is not UTF-8.
std::string toml_string(std::string_view text);
/// Returns the shortest form that reads back to the same bits, spelled as a float: "500.0", "-0.0",
/// "inf", "nan".
std::string toml_number(double value);
std::string toml_value(const ParameterValue& value);
/// Returns an array of many numbers, `per_line` on each line.
std::string toml_lines(const std::vector<double>& values, std::size_t per_line);

}  // namespace ocean
