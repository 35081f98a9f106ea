// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The parser of command lines: from the words after a program's name to a command whose options
// have their values, or to the sentence that says what is wrong with them.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "command.hpp"

namespace ocean::app {

struct ParsedCommand {
    const Command& command;           // of the program; the program's main if it has no commands
    std::optional<std::string> text;  // of --help or --version, to print in place of a run
    std::vector<GivenOption> given = {};
};

/// Returns the command that `words` request, and assigns their values to the targets of its
/// options. A command whose name has two words wins over an argument of the command with the first
/// word alone: a file named `import` is given as `./import`. Throws Error invalid_value, with the
/// nearest names for an unknown command, option or page of help.
ParsedCommand parse_command_line(const Program& program, std::span<char* const> words,
                                 RunOptions& run_options);

/// Assigns a value to the target of an option. Throws Error invalid_value for a value
/// that the rule or the type of the option refuses.
void assign(const Option& option, const std::string& value, RunOptions& run_options);

}  // namespace ocean::app
