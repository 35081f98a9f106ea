// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The size that a classic NetCDF file must have by its own header. libnetcdf reads the missing end
// of a truncated file as zeros, which would be a calm sea.
#pragma once

#include <cstdint>
#include <istream>

namespace ocean::netcdf {

/// Returns the bytes up to the end of the last variable without up to 3 bytes of padding, or 0 for
/// a header that cannot be parsed. [NetCDF classic format specification: CDF-1, CDF-2, CDF-5]
std::uint64_t classic_extent(std::istream& file);

}  // namespace ocean::netcdf
