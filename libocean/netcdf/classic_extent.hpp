// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// How long a classic NetCDF file has to be by its own header. libnetcdf reads the lost end of a
// file that was cut off as zeros, which would be a calm sea.
#pragma once

#include <cstdint>
#include <istream>

namespace ocean::netcdf {

/// Bytes to the end of the last variable, up to 3 of padding left out; 0 if the header cannot be
/// followed. [NetCDF classic format specification: CDF-1, CDF-2, CDF-5]
std::uint64_t classic_extent(std::istream& file);

}  // namespace ocean::netcdf
