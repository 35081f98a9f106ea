// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Reads a NetCDF file by libnetcdf, in the calling process. Only this part links libnetcdf. Neither
// libnetcdf nor HDF5 is safe against hostile files, so the program calls it in a child process.
#pragma once

#include <string>

#include "netcdf_content.hpp"

namespace ocean::netcdf {

/// Returns the variables of the spectrum, unpacked. Checks all sizes before it reads. Throws Fault.
Content read_file(const std::string& path);

}  // namespace ocean::netcdf
