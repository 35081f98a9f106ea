// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The argument "-" in place of a file.
#pragma once

#include <cstddef>
#include <string>

namespace ocean::app {

inline constexpr const char* kStandardInput = "-";

/// All of it. Throws Error bad_file for more than `limit` bytes, and for the second who asks.
std::string read_standard_input(std::size_t limit);

}  // namespace ocean::app
