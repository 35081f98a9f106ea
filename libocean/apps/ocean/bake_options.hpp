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
#include "region_argument.hpp"
#include "subject_argument.hpp"

namespace ocean::app {

/// Options of formats without a value, by their names: whether they were given.
using FormatFlags = std::map<std::string, bool>;

/// The arguments of `ocean bake` or `ocean terrain`, as typed.
struct BakeArguments {
    std::string_view kind;  // of the subject
    BakeOptions bake;
    SubjectArgument subject;
    RegionArgument region;
    FormatFlags format_options;
    std::string tiles, egl_device, stage;
    bool dry_run = false;
    bool summary = false;
};
/// Returns the options of a bake, without those of its run (--threads and so on); the first group
/// is the subject. The arguments must outlive them.
std::vector<OptionGroup> bake_options(BakeArguments& typed, const Catalogue& catalogue);
/// Throws Error.
BakePlan plan_bake(const BakeArguments& typed, const Catalogue& catalogue, const Context& context);

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
