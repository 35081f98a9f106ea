// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Which variable of a NetCDF file is the spectrum, and which are its coordinates: found by names,
// standard names and dimensions, never by values, so that only what is needed has to be read.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "netcdf_content.hpp"

namespace ocean::netcdf {

/// Indices of variables and dimensions of the content.
struct Layout {
    std::size_t spectrum = 0;
    std::size_t frequency_dimension = 0;
    std::optional<std::size_t> direction_dimension;
    std::vector<std::size_t> outer_dimensions;  // a record for each point: time, then places
    // Coordinates. ECMWF may leave out frequency and direction, which are indices there.
    std::optional<std::size_t> frequency, direction;
    std::optional<std::size_t> time, latitude, longitude, depth, station;
    // What NDBC has beside a spectrum without directions, over the same dimensions: the mean and
    // the principal direction, r1 and r2; all or none.
    std::optional<std::array<std::size_t, 4>> buoy_directions;

    /// Variables without repetition.
    std::vector<std::size_t> variables() const;
};
/// Needs no values. Throws Fault.
Layout find_layout(const Content& content);

/// ECMWF's 2-D wave spectra: the decimal logarithm of m^2 s/rad.
bool is_ecmwf(const Variable& spectrum);

}  // namespace ocean::netcdf
