// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The command `ocean-bridge`, by which boards and networks set the parameters of a sea, as a
// function that tests call too.
#pragma once

namespace ocean::app {

/// Returns the exit code; see run_program().
int run_bridge(int argc, char** argv);

}  // namespace ocean::app
