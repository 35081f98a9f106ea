// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A NetCDF file by way of libnetcdf, in this process: the only part that links it. Neither
// libnetcdf nor HDF5 is made for hostile files, so the program calls it in a child process.
#pragma once

#include <string>

#include "netcdf_content.hpp"

namespace ocean::netcdf {

/// The variables of the spectrum, unpacked. Sizes are checked before anything is read. Throws
/// Fault.
Content read_file(const std::string& path);

}  // namespace ocean::netcdf
