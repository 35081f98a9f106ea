// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Tracks of hulls as text: CSV and GPX files, and the rows that a sea file carries.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "gpx_track.hpp"
#include "ocean/internal/hull_rules.hpp"
#include "ocean/parameters.hpp"
#include "toml_input.hpp"

namespace ocean {

/// The key of the rows beside the parameters of [[hulls]].
inline constexpr std::string_view kTrackKey = "track";
inline constexpr std::size_t kMaxTrackBytes = std::size_t{64} << 20;

/// Parses a CSV file with a header: columns time, x, y; with heading and speed too; or x, y, speed,
/// way points whose times follow from the speeds, from time 0 on. Throws Error bad_file
/// "NAME:LINE: ...".
HullTrack parse_track(std::string_view content, const std::string& name);

/// Returns the points of a GPX file as the track of a hull, by its origin and origin_time. Throws
/// Error invalid_value "NAME: ...".
HullTrack placed_track(const std::vector<GpxPoint>& points, const Hull& hull,
                       const std::string& name);

/// Reads rows [time, x, y] or [time, x, y, heading, speed] of a sea file; `name` is the parameter.
/// Throws Error invalid_value.
HullTrack read_track_rows(const TomlEntry& entry, const std::string& name);

/// Reads the track that `track_file` of hulls.`hull` names, unless the hull has one. Throws errors
/// of that parameter.
void resolve_track(Hull& hull, std::size_t number, const std::string& base_dir);

/// Returns the rows as a sea file has them, "track = [...]"; "" for a hull without a track.
std::string track_text(const Hull& hull);

}  // namespace ocean
