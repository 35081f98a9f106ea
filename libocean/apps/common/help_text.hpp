// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The text of --help: made from commands as values, at most 80 columns wide, so that it can be read
// in any terminal and a program reads the same text everywhere.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "command.hpp"

namespace ocean::app {

inline constexpr std::size_t kHelpColumns = 80;

/// Returns the help of a command, with `usage` as its name: "ocean bake". `commands` are those that
/// may follow it; the program itself has --version among its options.
std::string command_help(const Command& command, const std::string& usage,
                         const std::vector<HelpRow>& commands, bool has_version);

/// Returns the text of one page.
std::string page_help(const HelpPage& page);

/// Returns "-o, --output FILE" for an option, as a row of a HelpSection names it.
std::string option_name(const Option& option);

}  // namespace ocean::app
