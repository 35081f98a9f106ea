// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// What this program can bake, and with what.
#pragma once

#include "ocean/bake/catalogue.hpp"

namespace ocean::app {

/// standard_catalogue(), and the GPU's backends where the program was built with them.
const Catalogue& ocean_catalogue();

}  // namespace ocean::app
