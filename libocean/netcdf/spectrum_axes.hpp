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
    std::vector<double> frequency;             // [Hz], ascending
    std::vector<std::size_t> frequency_order;  // indices in the file, in that order
    bool angular_frequency = false;            // the file has rad/s
    std::optional<DirectionAxis> directions;   // if the spectrum has directions
    bool radian_bins = false;                  // the file has radians
    std::vector<std::string> warnings;         // assumptions about the file
};
/// Reads the axes of the spectrum. Throws Fault for a unit or a value that is not allowed.
SpectrumAxes read_axes(const Content& content, const Layout& layout);

}  // namespace ocean::netcdf
