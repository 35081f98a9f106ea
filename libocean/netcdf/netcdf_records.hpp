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
/// value is no record, one that cannot be used has its `fault`: "VARIABLE: what is wrong". What had
/// to be assumed of the file is among the warnings of each record. Throws Fault for what concerns
/// all records.
std::vector<SpectrumRecord> records_from(const Content& content);

}  // namespace ocean::netcdf
