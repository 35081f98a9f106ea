// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Seas of a map: the water that reaches the border.
#pragma once

#include <span>

#include "field/grid_lines.hpp"

namespace ocean {

/// Changes the sign of all samples <= 0 that no path of such samples, along rows and columns,
/// connects with the border; samples of 0 become the smallest normal float.
void raise_cut_off_seas(std::span<float> map, const SampleGrid& grid);

}  // namespace ocean
