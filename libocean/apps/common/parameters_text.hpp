// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A table of parameters for a terminal.
#pragma once

#include <span>
#include <string>

#include "ocean/table.hpp"

namespace ocean::app {

/// Returns the rows below the headings of their sections, as a file has them: default, allowed
/// values and help of each.
std::string parameters_text(std::span<const ListedParameter> parameters);

}  // namespace ocean::app
