// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Tracks of satellite receivers: the points <trkpt lat="" lon=""><time/></trkpt> of GPX files.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/parameters.hpp"

namespace ocean {

/// A point on the ellipsoid WGS84.
struct GpxPoint {
    double latitude = 0.0;   // [degrees]
    double longitude = 0.0;  // [degrees]
    double time = 0.0;       // since 1970, UTC [s]
};

/// Returns true for a text that is XML, if anything.
bool is_xml(std::string_view content);

/// Parses a GPX file strictly: its track points, of all tracks and segments in order, and nothing
/// else. Throws Error bad_file "NAME:LINE: ..." with the number of the point.
std::vector<GpxPoint> parse_gpx(std::string_view content, const std::string& name);

/// Parses a time such as "2026-05-01T10:00:03.5Z" or "2026-05-01T12:00:03.5+02:00"; UTC without a
/// zone. Returns seconds since 1970; nothing for other texts.
std::optional<double> parse_gpx_time(std::string_view text);
/// Returns the sentence on another text: "KEY = 'TEXT'; allowed is ...".
std::string not_a_time(std::string_view key, std::string_view text);

/// Returns the points as rows in the tangent plane of a place, x to the east and y to the north
/// [m], with times after `start` [s since 1970]. Throws Error invalid_value for a point more than
/// 100 km away.
HullTrack track_of(const std::vector<GpxPoint>& points, const GpxPoint& origin, double start,
                   const std::string& name);

}  // namespace ocean
