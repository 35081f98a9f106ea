// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// What `ocean spectrum` prints: the table that modes, CPU and GPU read.
#pragma once

#include <string>

#include "ocean/directional_spectrum.hpp"

namespace ocean::app {

/// One line for each row of the table, so that the trapezoid over them is the exact variance.
std::string frequency_csv(const DirectionalSpectrum& spectrum);
/// One line for each row and direction.
std::string directional_csv(const DirectionalSpectrum& spectrum);

}  // namespace ocean::app
