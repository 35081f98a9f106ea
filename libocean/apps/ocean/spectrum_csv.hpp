// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The CSV of `ocean spectrum`: the table that modes, CPU and GPU share.
#pragma once

#include <string>

#include "ocean/internal/directional_spectrum.hpp"

namespace ocean::app {

/// Returns a line for each row of the table; the trapezoidal rule over them is the exact variance.
std::string frequency_csv(const DirectionalSpectrum& spectrum);
/// Returns a line for each row and direction.
std::string directional_csv(const DirectionalSpectrum& spectrum);

}  // namespace ocean::app
