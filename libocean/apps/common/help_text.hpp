// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The text of --help: made from commands as values, at most 80 columns wide, so that it can be read
// in any terminal and a program reads the same text everywhere.
#pragma once

#include <string>

#include "command.hpp"

namespace ocean::app {

inline constexpr std::size_t kHelpColumns = 80;

/// Returns the name by which a user calls a command, "ocean bake"; of the program's main, "ocean".
std::string usage_of(const Program& program, const Command& command);

/// Returns the help of a command of the program, or of its main.
std::string command_help(const Program& program, const Command& command);

/// Returns the text of one page.
std::string page_help(const HelpPage& page);

/// Returns "-o, --output FILE" for an option, as a row of a HelpSection names it.
std::string option_name(const Option& option);

}  // namespace ocean::app
