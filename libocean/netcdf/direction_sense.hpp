// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// What a NetCDF file says of its directions: whether waves come from them or travel to them, and
// where they are measured from. Words decide, in the attributes of the variable first.
#pragma once

#include <complex>
#include <optional>
#include <string>
#include <string_view>

#include "netcdf_content.hpp"

namespace ocean::netcdf {

/// How directions are measured; as it stands: where waves come from, clockwise from north.
struct DirectionSense {
    bool from = true;  // else the direction that they travel to
    bool counter_clockwise = false;
    bool from_east = false;
    bool operator==(const DirectionSense&) const = default;

    /// The travel direction of one that is measured so, degrees counter-clockwise from east.
    double travel(double degrees) const;
    /// The moment of order n about the travel direction, a_n + i b_n, of one that is measured so.
    std::complex<double> travel_moment(std::complex<double> moment, int n) const;
    /// "where waves come from, clockwise from north".
    std::string text() const;
};
inline constexpr DirectionSense kComingFrom{};
inline constexpr DirectionSense kTravellingTo{false, false, false};
inline constexpr DirectionSense kTravellingToFromEast{false, true, true};

/// What a text says of directions; nothing where it says nothing or contradicts itself.
struct DirectionWords {
    std::optional<bool> from, counter_clockwise, from_east;
};
DirectionWords direction_words(std::string_view text);

/// The sense of a variable and how it was found.
struct FoundSense {
    DirectionSense sense;
    bool told = false;    // by the file, in words or by its writer's convention
    std::string warning;  // what of the file contradicts it; or empty
};
/// Asks in this order: the writer where it is one that names directions wrongly (SWAN); the
/// standard_name of the directions, their long_name, units and other attributes; those of the
/// spectrum; those of the file; `writer`, the convention of the writer whose names the file has. If
/// all are silent, waves come from there, and `told` is false.
FoundSense direction_sense(const Content& content, const Variable& directions,
                           const Variable& spectrum, std::optional<DirectionSense> writer);

/// What to tell of directions of which a file does not say how they are measured.
std::string silent_directions(const Variable& directions, const DirectionSense& taken);

/// SWAN's own files: densities that may be scaled by a variable, and directions whose
/// standard_name may contradict the run's convention.
bool is_swan(const Content& content, const Variable& spectrum);

}  // namespace ocean::netcdf
