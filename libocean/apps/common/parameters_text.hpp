// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A table of parameters as text for a terminal.
#pragma once

#include <span>
#include <string>

#include "ocean/table.hpp"

namespace ocean::app {

/// Returns default, allowed values and help of each parameter, below the headings of their sections
/// in a file.
std::string parameters_text(std::span<const ListedParameter> parameters);

}  // namespace ocean::app
