// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Converts the variables of a NetCDF file to records in libocean's conventions. Independent of
// libnetcdf, so that the input may come from anywhere.
#pragma once

#include <vector>

#include "netcdf_content.hpp"
#include "ocean/parameters.hpp"

namespace ocean::netcdf {

/// Returns the records of a consistent content, such as decode() returns, ordered by time and then
/// by place. A time and place without a value gives no record; a record that cannot be used has a
/// `fault`, "VARIABLE: problem". Each record's warnings include the assumptions about the file.
/// Throws Fault for a problem of all records.
std::vector<SpectrumRecord> records_from(const Content& content);

}  // namespace ocean::netcdf
