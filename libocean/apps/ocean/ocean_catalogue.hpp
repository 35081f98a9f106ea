// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The catalogue of bakes of the `ocean` command.
#pragma once

#include "ocean/bake/catalogue.hpp"

namespace ocean::app {

/// Returns standard_catalogue() with the GPU's backends if the program was built with them.
const Catalogue& ocean_catalogue();

}  // namespace ocean::app
