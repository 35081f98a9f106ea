// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// From the variables of a NetCDF file to records, in libocean's conventions. Knows nothing of
// libnetcdf: its input may come from anywhere.
#pragma once

#include <vector>

#include "netcdf_content.hpp"
#include "ocean/spectrum_record.hpp"

namespace ocean::netcdf {

/// Needs a consistent content: what decode gives. Times outermost; a time and place without any
/// value is no record. Throws Fault.
///
/// A direction is where waves come from or travel to as its standard_name or long_name says. If
/// they say nothing: `d2fd` and a coordinate named `direction` travel to (ECMWF, WAVEWATCH III),
/// all others come from (wavespectra's `dir`).
std::vector<SpectrumRecord> records_from(const Content& content);

}  // namespace ocean::netcdf
