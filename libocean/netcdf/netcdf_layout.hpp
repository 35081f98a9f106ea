// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Finds the spectrum and its coordinates among the variables of a NetCDF file by names, standard
// names, units and dimensions. Values are not used, so that only the needed ones must be read.
#pragma once

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "netcdf_content.hpp"

namespace ocean::netcdf {

/// Directional quantities for each frequency beside a spectrum without directions.
enum BinQuantity : std::size_t {
    kA1,
    kB1,
    kA2,
    kB2,  // moments
    kMean,
    kPrincipal,  // directions of the first and of the second moment
    kR1,
    kR2,  // ratios: the lengths of the moments
    kSpread,
    kPrincipalSpread,  // circular standard deviations of both
    kBinQuantities
};
using BinVariables = std::array<std::optional<std::size_t>, kBinQuantities>;

/// Indices of variables and dimensions of the content.
struct Layout {
    std::size_t spectrum = 0;
    std::size_t frequency_dimension = 0;
    std::optional<std::size_t> direction_dimension;
    std::vector<std::size_t> outer_dimensions;  // a record for each point: time, then places
    // Coordinates. ECMWF may leave out frequency and direction, which are indices there.
    std::optional<std::size_t> frequency, direction;
    std::optional<std::size_t> time, latitude, longitude, depth, station;
    // Dimensions of places that run along with time (first, second): positions of a buoy that
    // drifts, as Copernicus' files have them.
    std::vector<std::pair<std::size_t, std::size_t>> parallel_dimensions;
    std::optional<std::size_t> scale;  // of densities, over outer dimensions: SWAN's
    BinVariables bins;                 // over the frequency dimension and some of the outer ones
    // Flags of quality: of records, of frequencies, or of both; with the variable that they judge.
    std::vector<std::pair<std::size_t, std::size_t>> flags;

    /// Variables without repetition.
    std::vector<std::size_t> variables() const;
};
/// Needs no values. Throws Fault.
Layout find_layout(const Content& content);

/// ECMWF's 2-D wave spectra: the decimal logarithm of m^2 s/rad.
bool is_ecmwf(const Variable& spectrum);

}  // namespace ocean::netcdf
