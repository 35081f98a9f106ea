// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A program's commands and options as JSON. packaging/command_pages.py makes manual pages and
// completions of shells from it.
#pragma once

#include <string>

#include "command.hpp"

namespace ocean::app {

/// Returns what `PROGRAM --describe` prints: an object with `version` and `commands`, the program
/// itself first. A command has name, summary, footer, runs, groups of options and pages of help. An
/// option has names, type, help, required, takes ("nothing", "value" or "optional value"),
/// repeats, words (those that its value may have, empty for any) and excludes.
std::string description(const Program& program);

}  // namespace ocean::app
