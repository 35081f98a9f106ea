// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The formats of this folder, and what several of them need.
#pragma once

#include <vector>

#include "ocean/bake/format.hpp"

namespace ocean {

extern const BakeFormat kExrFormat;
extern const BakeFormat kDf3Format;
extern const BakeFormat kHeightFieldFormat;
extern const BakeFormat kMesh2Format;

/// R, R/2, ... 32.
std::vector<int> halving_resolutions(int resolution);

}  // namespace ocean
