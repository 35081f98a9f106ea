// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The words of a command line before the parser reads them: a mistyped command or option is refused
// with the name that was probably meant, and a request for help finds its page.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "command_line.hpp"

namespace ocean::app {

/// Returns the text of the help that the words request, or nothing. `words` are those after the
/// program's name. Throws Error invalid_value for an unknown command, option or page of help.
std::optional<std::string> requested_help(const Program& program, std::span<char* const> words);

/// Returns the help of the command with that name; "" = the program's.
std::string help_of(const Program& program, const std::string& command);

}  // namespace ocean::app
