// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// NAME=VALUE, as --set gives it to a parameter.
#pragma once

#include <string>
#include <string_view>

namespace ocean::app {

struct Assignment {
    std::string name;
    std::string value;  // may be empty
};

/// Returns the parts of the argument of a --set. example: an assignment that an error shows. Throws
/// Error invalid_value.
Assignment parse_assignment(const std::string& text, std::string_view example);

}  // namespace ocean::app
