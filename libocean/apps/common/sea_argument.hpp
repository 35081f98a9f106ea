// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The SEA argument and --set, which most commands share: from words on the command line to a
// resolved, validated sea.
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

/// SEA and --set.
OptionGroup sea_options(SeaArgument& argument, bool required = kRequired);

/// Throws Error.
Sea open_sea(const SeaArgument& argument);
/// What --set does to a sea that is open: a file that is named is read, from where the user stands.
/// Throws Error, after which the sea is of no use.
void set_in_sea(Sea& sea, const std::string& name, const std::string& value);

}  // namespace ocean::app
