// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Finds the convention of a NetCDF file's directions: if waves come from them or travel to them,
// and the axis they are measured from. Words decide, first those in the attributes of the variable.
#pragma once

#include <complex>
#include <optional>
#include <string>
#include <string_view>

#include "netcdf_content.hpp"

namespace ocean::netcdf {

/// A convention of directions. The default is the direction waves come from, clockwise from north.
struct DirectionSense {
    bool from = true;  // false: the direction that waves travel to
    bool counter_clockwise = false;
    bool from_east = false;
    bool operator==(const DirectionSense&) const = default;

    /// Converts a direction [degrees] of this convention to the travel direction, counter-clockwise
    /// from east [degrees].
    double travel(double degrees) const;
    /// Converts a moment a_n + i b_n of this convention to the moment of order n about the travel
    /// direction.
    std::complex<double> travel_moment(std::complex<double> moment, int n) const;
    /// Returns the convention in words: "where waves come from, clockwise from north".
    std::string text() const;
};
inline constexpr DirectionSense kComingFrom{};
inline constexpr DirectionSense kTravellingTo{false, false, false};
inline constexpr DirectionSense kTravellingToFromEast{false, true, true};

/// The parts of a convention that a text gives. A part is unset if the text is silent about it or
/// contradicts itself.
struct DirectionWords {
    std::optional<bool> from, counter_clockwise, from_east;
};
DirectionWords direction_words(std::string_view text);

/// The sense of a variable and how it was found.
struct FoundSense {
    DirectionSense sense;
    bool told = false;    // true if the file gives it, in words or by its writer's convention
    std::string warning;  // the part of the file that contradicts it; or empty
};
/// Returns the first convention found in: the writer, if it is one that names directions wrongly
/// (SWAN); the standard_name of the directions, their long_name, units and other attributes; the
/// attributes of the spectrum; those of the file; `writer`, the convention of the writer whose
/// names the file has. If all are silent, it is the direction waves come from, with `told` false.
FoundSense direction_sense(const Content& content, const Variable& directions,
                           const Variable& spectrum, std::optional<DirectionSense> writer);

/// Returns the warning about directions whose convention the file does not give.
std::string silent_directions(const Variable& directions, const DirectionSense& taken);

/// Returns true for SWAN's own files, whose densities may be scaled by a variable and whose
/// standard_name of directions may contradict the run's convention.
bool is_swan(const Content& content, const Variable& spectrum);

}  // namespace ocean::netcdf
