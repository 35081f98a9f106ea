// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Spectra from NetCDF files, as written by ERA5, wavespectra, WAVEWATCH III, SWAN, NDBC, CDIP,
// Copernicus and others. Only the tools read them: libocean.so and ocean::seafile never link
// libnetcdf. A file passes four stages, each of which knows only the next: netcdf_file (libnetcdf)
// in a child process -> netcdf_wire (a pipe) -> netcdf_layout (the roles of the variables) ->
// netcdf_records.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "ocean/parameters.hpp"

namespace ocean {

/// Returns true if a file begins like NetCDF: classic, with 64-bit offsets, with 64-bit data, or
/// HDF5. Eight bytes suffice.
bool is_netcdf(std::string_view first_bytes);

/// Returns one record for each time and place with a spectrum, times outermost; a record that
/// cannot be used has its `fault` set. libnetcdf runs in a child process, so that a file which
/// crashes it causes an error only. Throws Error bad_file "PATH: VARIABLE: FAULT" if no record can
/// be used, unsupported in a program built without NetCDF, and interrupted.
std::vector<SpectrumRecord> read_netcdf_spectra(const std::string& path);

}  // namespace ocean
