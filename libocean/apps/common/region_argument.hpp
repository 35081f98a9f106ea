// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The options --region and --cell of commands that show a part of a land or of a coast.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "command.hpp"
#include "ocean/domain.hpp"

namespace ocean::app {

/// The options --region and --cell as they were typed; "" = not given.
struct RegionArgument {
    std::string region, cell;
};
/// Returns the options --region and --cell.
std::vector<Option> region_options(RegionArgument& argument);
/// Returns the region that is typed, if one is. Throws Error invalid_value.
std::optional<Region> parse_region(const RegionArgument& argument);

}  // namespace ocean::app
