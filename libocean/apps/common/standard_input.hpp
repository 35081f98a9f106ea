// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Standard input, for the argument "-" in place of a file.
#pragma once

#include <cstddef>
#include <string>

namespace ocean::app {

inline constexpr const char* kStandardInput = "-";

/// Returns all of standard input. Throws Error bad_file for more than `limit` bytes, and at the
/// second call.
std::string read_standard_input(std::size_t limit);

}  // namespace ocean::app
