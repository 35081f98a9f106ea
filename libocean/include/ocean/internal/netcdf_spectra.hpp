// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Spectra from NetCDF, as ERA5, wavespectra, WAVEWATCH III, SWAN, NDBC, CDIP, Copernicus and others
// write it. For the tools alone:
// libocean.so and ocean::seafile never link libnetcdf. A file goes through four stages, each
// of which knows only the next: netcdf_file (libnetcdf) in a child process -> netcdf_wire (a pipe)
// -> netcdf_layout (which variable plays which part) -> netcdf_records.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "ocean/spectrum_record.hpp"

namespace ocean {

/// Whether a file begins like NetCDF: classic, with 64-bit offsets, with 64-bit data, or HDF5.
/// Eight bytes are enough.
bool is_netcdf(std::string_view first_bytes);

/// One record for each time and place that has a spectrum, times outermost; one that cannot be used
/// has its `fault`. Throws Error bad_file "PATH: VARIABLE: what is wrong" where none can be used,
/// unsupported in a program built without NetCDF, and interrupted.
/// libnetcdf runs in a child process, so that a file that crashes it costs an error and no more.
std::vector<SpectrumRecord> read_netcdf_spectra(const std::string& path);

}  // namespace ocean
