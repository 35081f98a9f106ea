// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The names of directional quantities for each frequency, as writers spell them: CDIP, NDBC,
// Copernicus, WAVEWATCH III, SWAN, Spotter and others.
#pragma once

#include <string>

#include "netcdf_layout.hpp"

namespace ocean::netcdf {

/// Returns how well a variable's names fit a quantity, 0 if they do not.
int bin_rank(BinQuantity quantity, const std::string& name, const std::string& standard_name);
/// Returns true for a name whose writers all mean the direction that waves come from.
bool is_known_to_come_from(const std::string& name);

}  // namespace ocean::netcdf
