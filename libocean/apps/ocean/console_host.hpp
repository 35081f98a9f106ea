// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Bakes from a terminal, and what they will write.
#pragma once

#include "command.hpp"
#include "console.hpp"
#include "ocean/bake/plan.hpp"
#include "ocean/internal/bake/estimate.hpp"

namespace ocean::app {

/// Bakes the plan. Reports go to the console, and Ctrl-C waits until the current files are
/// complete.
void bake_on_console(const BakePlan& plan, const Context& context);
/// Reports how many files a run writes, their sizes and its memory, and warns where there is no
/// room. `beside` are files of the same run that are not baked.
void report_forecast(const BakeForecast& forecast, const BakeForecast& beside, Console& console);
/// Does so for a dry run, and prints the files.
void show_forecast(const BakeForecast& forecast, const BakeForecast& beside, Console& console);

}  // namespace ocean::app
