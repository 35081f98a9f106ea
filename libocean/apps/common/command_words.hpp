// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The words of a command line before the parser reads them: a mistyped command or option is refused
// with the name that was probably meant, and a request for help finds its page.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "command_line.hpp"

namespace ocean::app {

/// A command line after its command was found.
struct CommandWords {
    std::optional<std::string> help;  // the text of the help that the words request
    /// The words for the parser, which knows a command by parser_name(): "terrain", "import" are
    /// one word.
    std::vector<std::string> words;
};

/// Returns the command line of `words`, those after the program's name. A command whose name has
/// two words wins over a positional argument of the command with the first word alone: a file named
/// `import` is given as `./import`. Throws Error invalid_value for an unknown command, option or
/// page of help.
CommandWords read_command_words(const Program& program, std::span<char* const> words);

/// Returns the name by which the parser knows a command; it has no blank.
std::string parser_name(const Command& command);

/// Returns the help of the command with that name, "terrain import"; "" = the program's.
std::string help_of(const Program& program, const std::string& command);

}  // namespace ocean::app
