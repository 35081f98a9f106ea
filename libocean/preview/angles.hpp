// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Cameras and suns are said in degrees, and reckoned with in radians.
#pragma once

#include "ocean/grid.hpp"

namespace ocean::preview {

inline constexpr double kRadians = kPi / 180.0;  // of a degree

}  // namespace ocean::preview
