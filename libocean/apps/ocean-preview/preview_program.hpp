// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The command `ocean-preview`, from a sea file or a terrain file to its picture, as a function that
// tests call too.
#pragma once

namespace ocean::app {

/// Returns the exit code; see run_program().
int run_preview(int argc, char** argv);

}  // namespace ocean::app
