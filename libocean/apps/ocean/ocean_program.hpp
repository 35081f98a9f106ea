// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The `ocean` command as a function, so that its main is a line and a test can add to it.
#pragma once

namespace ocean::app {

/// The exit code; see run_program().
int run_ocean(int argc, char** argv);

}  // namespace ocean::app
