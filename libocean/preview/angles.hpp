// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Options give angles in degrees; formulas use radians.
#pragma once

#include "ocean/internal/grid.hpp"

namespace ocean::preview {

inline constexpr double kRadians = kPi / 180.0;  // [rad] of a degree

}  // namespace ocean::preview
