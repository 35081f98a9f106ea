// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The parts of a command that bakes, for seas and terrains alike: the options of the formats, and
// the run of a plan.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "command.hpp"
#include "ocean/bake/catalogue.hpp"
#include "ocean/bake/plan.hpp"

namespace ocean::app {

/// Options of formats without a value, by their names: whether they were given.
using FormatFlags = std::map<std::string, bool>;

/// Appends the options of all formats that subjects of a kind can have, a group for each family of
/// formats, and forbids empty values in all groups but the first. Both targets must outlive the
/// groups.
void add_format_options(FormatFlags& flags, BakeOptions& bake, const Catalogue& catalogue,
                        std::string_view kind, std::vector<OptionGroup>& groups);
/// Adds the flags that were given to the options of a bake.
void add_given(const FormatFlags& flags, BakeOptions& options);

/// Bakes, or with dry_run prints the files and the disk space that they need. Throws Error.
void run_or_forecast(const BakePlan& plan, bool dry_run, const Context& context);
/// Prints the sums of a forecast, with the seconds of its frames. Throws Error.
void show_summary(const BakePlan& plan, const Context& context);

}  // namespace ocean::app
