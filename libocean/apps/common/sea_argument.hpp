// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The argument SEA and the option --set, which most commands share, and the resolved and validated
// sea that they name.
#pragma once

#include <string>
#include <vector>

#include "command.hpp"
#include "ocean/sea.hpp"

namespace ocean::app {

struct SeaArgument {
    std::string source;                    // a sea file, a baked .exr, or preset:NAME
    std::vector<std::string> assignments;  // name=value, in order
};

/// Returns the options SEA and --set.
OptionGroup sea_options(SeaArgument& argument, bool required = kRequired);

/// Returns the sea. Throws Error.
Sea open_sea(const SeaArgument& argument);
/// Sets a parameter of an open sea as --set does: a file that the value names is read, relative to
/// the working directory. Throws Error, after which the sea must not be used.
void set_in_sea(Sea& sea, const std::string& name, const std::string& value);

}  // namespace ocean::app
