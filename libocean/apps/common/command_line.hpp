// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The main function of a program with commands.
#pragma once

#include "command.hpp"

namespace ocean::app {

/// Parses the command line and runs one command. Prints an error as one line on standard error and
/// returns the exit code: 0 done, 1 failed at run time, 2 wrong usage or bad sea file, 130
/// interrupted. Must be called before other threads are started.
int run_program(int argc, char** argv, const Program& program);

}  // namespace ocean::app
