// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "hulls/hull_summary.hpp"

#include <algorithm>
#include <cmath>

#include "hulls/wake.hpp"
#include "ocean/internal/grid.hpp"
#include "ocean/internal/hull_rules.hpp"
#include "ocean/internal/text.hpp"

namespace ocean {
namespace {

/// Returns the height of the waves from trough to crest, one length beside the hull at a time.
double height_beside(Wake& wake, const Hull& hull, double time, double loop_period,
                     ThreadPool& pool) {
    wake.move_to(time, false, pool);
    const TrackPath path(hull.track, loop_period);
    const PathVector at = path.place(time);
    const PathVector ahead = path.heading(time);
    const WakeSize& size = wake.size();
    float lowest = 0.0f, highest = 0.0f;
    for (double back = 0.0; back < 0.5 * size.side; back += size.side / size.resolution) {
        for (const double side : {-hull.length, hull.length}) {
            const double x = at.x - back * ahead.x - side * ahead.y;
            const double y = at.y - back * ahead.y + side * ahead.x;
            if (!wake.holds(x, y)) continue;
            const float height = wake.read(x, y).height.value();
            lowest = std::min(lowest, height);
            highest = std::max(highest, height);
        }
    }
    return static_cast<double>(highest - lowest);
}

}  // namespace

HullSummary hull_summary(const Hull& hull, const Water& water, double loop_period,
                         ThreadPool& pool) {
    const auto [speed, time] = fastest_leg(*hull.track);
    const WakeSize size = wake_size(hull, speed, water);
    HullSummary summary{.begin = hull.track->rows.front().time,
                        .end = hull.track->rows.back().time,
                        .speed = speed,
                        .froude_number = speed / std::sqrt(water.gravity * hull.length),
                        .volume = hull_volume(hull),
                        .wavelength = kTwoPi * speed * speed / water.gravity,
                        .wake_size = size.side,
                        .wake_cell = size.side / size.resolution};
    if (!(speed > 0.0)) return summary;
    Wake wake(hull, water, loop_period, pool);
    summary.wave_height = height_beside(wake, hull, time, loop_period, pool);
    // Both kinds of waves meet at two thirds of the transverse waves' length.
    summary.steepness = summary.wave_height / (2.0 / 3.0 * summary.wavelength);
    return summary;
}

std::vector<std::string> wake_warnings(const HullSummary& hull, std::string_view name) {
    constexpr double kSlow = 0.15;    // Froude number up to which hulls make no waves to speak of
    constexpr double kSamples = 4.0;  // of a wave at least
    constexpr double kSteep = 0.1;    // breaking waves
    const std::string of(name);
    std::vector<std::string> warnings;
    if (hull.froude_number >= kSlow && hull.wavelength < kSamples * hull.wake_cell) {
        warnings.push_back("the waves behind " + of + " are " + fixed_text(hull.wavelength, 1) +
                           " m long at its highest speed, and its wake has samples " +
                           fixed_text(hull.wake_cell, 1) +
                           " m apart, which leave most of them out: raise " + of +
                           ".wake_resolution, or make wake_size smaller");
    }
    if (hull.steepness > kSteep) {
        warnings.push_back(
            of + " makes waves of " + fixed_text(hull.wave_height, 2) +
            " m at its highest speed, one length beside it, " + fixed_text(hull.steepness, 2) +
            " of their length; linear theory, which makes them, holds to 0.1: make " + of +
            ".factor smaller, or the hull finer");
    }
    return warnings;
}

}  // namespace ocean
