// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Baking the frames of a plan, for all commands that do.
#pragma once

#include "bake_plan.hpp"
#include "command.hpp"

namespace ocean::app {

/// Bakes, or with dry_run prints the files and how much room they need. Says what it does and
/// prints the paths as they come. Throws Error.
void run_bake(BakePlan& plan, bool dry_run, const Context& context);

}  // namespace ocean::app
