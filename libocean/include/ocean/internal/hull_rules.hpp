// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Rules of hulls and of their tracks.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "ocean/parameters.hpp"

namespace ocean {

/// The max number of rows of all tracks of a sea: as text they fit into a sea file.
inline constexpr std::size_t kMaxTrackRows = 50000;
/// The max speed of a hull [m/s]: a row beyond it is a jump.
inline constexpr double kMaxHullSpeed = 60.0;
/// The max rate at which a moving hull turns [degrees/s].
inline constexpr double kMaxTurnRate = 45.0;

/// The fastest way between two rows.
struct FastestLeg {
    double speed = 0.0;  // [m/s]
    double time = 0.0;   // of its second row [s]
};
/// Returns the fastest leg of a valid track.
FastestLeg fastest_leg(const HullTrack& track);

/// Checks a track: two or more rows in order of time, finite numbers, no jump, no turn on the spot.
/// Throws Error invalid_value that names the row; `name` is the parameter.
void require_track(const HullTrack& track, const std::string& name);
/// Checks the rules of all hulls: each has a track, is longer than wide and deep, its wake's square
/// holds it, its draught is less than the depth, a loop has closed tracks. Throws Error
/// invalid_value, and unsupported over a bed.
void validate_hulls(const Parameters& parameters);
/// Returns warnings about the hulls of a valid sea, a sentence each.
std::vector<std::string> hull_warnings(const Parameters& parameters);

}  // namespace ocean
