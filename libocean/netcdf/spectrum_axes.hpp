// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Frequencies and directions of a spectrum in a NetCDF file, in libocean's units and convention.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "netcdf_layout.hpp"
#include "ocean/internal/directional_record.hpp"

namespace ocean::netcdf {

struct SpectrumAxes {
    std::vector<double> frequency;             // Hz, ascending
    std::vector<std::size_t> frequency_order;  // of the file, in that order
    bool angular_frequency = false;            // the file has rad/s
    std::optional<DirectionAxis> directions;   // where the spectrum has some
    bool radian_bins = false;                  // the file has radians
    std::vector<std::string> warnings;         // what had to be assumed
};
/// Throws Fault.
SpectrumAxes read_axes(const Content& content, const Layout& layout);

}  // namespace ocean::netcdf
