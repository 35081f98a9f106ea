// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The made products of this folder.
#pragma once

#include "ocean/bake/typed_format.hpp"

namespace ocean {

extern const MadeProduct kCaustics;
extern const MadeProduct kSlopeTiles;
extern const MadeProduct kTerrainStages;

}  // namespace ocean
