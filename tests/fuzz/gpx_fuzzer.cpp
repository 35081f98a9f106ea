// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A GPX file from any bytes gives places of the Earth with times, which lie in a plane or are
// refused, or one printable error.
#include <cmath>

#include "gpx_track.hpp"
#include "ocean/internal/hull_rules.hpp"
#include "reader_fuzzer.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace ocean;
    try {
        const std::vector<GpxPoint> points =
            parse_gpx({reinterpret_cast<const char*>(data), size}, "fuzz.gpx");
        fuzz::require(!points.empty() && points.size() <= kMaxTrackRows);
        for (const GpxPoint& point : points) {
            fuzz::require(std::abs(point.latitude) <= 90.0 && std::abs(point.longitude) <= 180.0);
            fuzz::require(std::isfinite(point.time));
        }
        const HullTrack track = track_of(points, points.front(), points.front().time, "fuzz.gpx");
        fuzz::require(track.rows.size() == points.size());
        for (const TrackRow& row : track.rows) {
            fuzz::require(std::hypot(row.x, row.y) <= 1e5 * (1.0 + 1e-9));
        }
    } catch (const Error& error) {
        fuzz::check_message(error.what());
    }
    return 0;
}
