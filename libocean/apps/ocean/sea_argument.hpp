// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The SEA argument and --set, which most commands share: from words on the command line to a
// resolved, validated sea.
#pragma once

#include <string>
#include <vector>

#include "ocean/sea.hpp"

namespace CLI {
class App;
}

namespace ocean::app {

struct SeaArgument {
    std::string source;                    // a sea file, a baked .exr, or preset:NAME
    std::vector<std::string> assignments;  // name=value, in order
};

void add_sea_argument(CLI::App& command, SeaArgument& argument);

/// Throws Error.
Sea open_sea(const SeaArgument& argument);

}  // namespace ocean::app
