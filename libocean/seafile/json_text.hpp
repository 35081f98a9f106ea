// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The two JSON values that need care: text, and numbers that JSON does not have.
#pragma once

#include <string>
#include <string_view>

namespace ocean {

/// Quoted; control characters escaped, broken UTF-8 replaced by '?'.
std::string json_string(std::string_view text);
/// Shortest form that reads back to the same bits; null for NaN and infinity.
std::string json_number(double value);

}  // namespace ocean
