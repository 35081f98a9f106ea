// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The `ocean` command as a function, so that its main is a line and a test can add to it.
#pragma once

#include "ocean/bake/catalogue.hpp"

namespace ocean::app {

/// The exit code; see run_program(). `catalogue`: what `ocean bake` can bake.
int run_ocean(int argc, char** argv, const Catalogue& catalogue = standard_catalogue());

}  // namespace ocean::app
