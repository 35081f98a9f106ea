// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The `ocean` command as a function, so that a test can extend its catalogue, and that catalogue.
#pragma once

#include "ocean/bake/catalogue.hpp"

namespace ocean::app {

/// Returns standard_catalogue() with the GPU's backends if the program was built with them.
const Catalogue& ocean_catalogue();

/// Returns the exit code; see run_program(). `catalogue` is that of `ocean bake`.
int run_ocean(int argc, char** argv, const Catalogue& catalogue = standard_catalogue());

}  // namespace ocean::app
