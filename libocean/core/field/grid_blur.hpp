// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A Gaussian blur whose time does not depend on its width.
#pragma once

#include <span>

#include "grid_lines.hpp"

namespace ocean {

/// The number of passes that a blur runs.
inline constexpr int kBlurPasses = 2;

/// Blurs a map in place by a Gaussian of the given deviation [samples], at most twice the longer
/// side of the grid, with the map continued beyond its border by the values of its edge.
void blur(std::span<float> map, const SampleGrid& grid, double deviation, GridPasses& passes);

}  // namespace ocean
