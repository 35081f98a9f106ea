// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// From main's arguments to one command that runs: the whole of a program's main.
#pragma once

#include <string>
#include <vector>

#include "command.hpp"

namespace ocean::app {

struct Program {
    /// Its name is the program's; its options stand before the command's name. It runs itself if
    /// there are no other commands.
    Command main;
    std::string version;  // what --version prints
    std::vector<Command> commands = {};
};

/// Parses, runs one command, and turns every failure into one line on standard error and an exit
/// code: 0 done, 1 failed at run time, 2 wrong usage or bad sea file, 130 interrupted. Call it
/// before there is any other thread.
int run_program(int argc, char** argv, const Program& program);

}  // namespace ocean::app
