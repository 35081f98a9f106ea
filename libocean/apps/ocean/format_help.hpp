// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The help of a bake's formats, made from the catalogue: a new format has its page without further
// text.
#pragma once

#include <vector>

#include "command.hpp"
#include "ocean/bake/catalogue.hpp"

namespace ocean::app {

/// Returns a page for each format: the files it writes, their products, its options, an example.
std::vector<HelpPage> format_pages(const Catalogue& catalogue);

/// Returns the help of an option of formats in the list of all options: that of the formats if they
/// agree, with their names, else where to read it.
std::string option_overview(const std::string& option, const Catalogue& catalogue);

}  // namespace ocean::app
