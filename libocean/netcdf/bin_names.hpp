// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// How writers name what they have of directions in each frequency: CDIP, NDBC, Copernicus,
// WAVEWATCH III, SWAN, Spotter and others.
#pragma once

#include <string>

#include "netcdf_layout.hpp"

namespace ocean::netcdf {

/// How well a variable's names fit a quantity; 0: not at all.
int bin_rank(BinQuantity quantity, const std::string& name, const std::string& standard_name);
/// Whether a variable of such a name is one of those whose writers all mean where waves come from.
bool is_known_to_come_from(const std::string& name);

}  // namespace ocean::netcdf
