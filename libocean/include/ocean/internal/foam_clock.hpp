// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The clock of the foam: its ticks, and how far back foam must be followed.
#pragma once

#include <cstdint>
#include <functional>

#include "ocean/parameters.hpp"

namespace ocean {

/// The foam's own clock: ticks n * step from t = 0, independent of the frame rate. In a loop the
/// step is foam_step rounded so that the loop is a whole number of ticks, and ticks are numbered
/// within the loop.
struct FoamClock {
    double step = 0.05;               // [s]
    double loop_period = 0.0;         // [s]; 0 = no loop
    std::int64_t ticks_per_loop = 0;  // 0 = no loop

    bool operator==(const FoamClock&) const = default;

    /// A time as its last tick and the time since that tick [s].
    struct Moment {
        std::int64_t tick;
        double since;
    };
    /// Returns the last tick at or before a time [s].
    Moment moment(double time) const;
    double time_of(std::int64_t tick) const;
    /// Returns the number of ticks from `from` to `to`; in a loop 0 .. ticks_per_loop - 1.
    std::int64_t ticks_between(std::int64_t from, std::int64_t to) const;
    /// Returns the tick `count` ticks before `tick`; count may be negative.
    std::int64_t before(std::int64_t tick, std::int64_t count) const;
};
/// Returns the clock of a sea with those settings; loop_period [s], 0 = no loop.
FoamClock foam_clock(const SurfaceSettings& settings, double loop_period);

/// Returns how many ticks before `tick` foam must begin to have the same bits as from any earlier
/// start: ceil(ln(512) lifetime / step) and a few more for the rounding of floats, at most one
/// loop. Where the lifetime changes, the number of ticks in which foam fades to 1/512.
std::int64_t preroll_ticks(const FoamClock& clock, std::int64_t tick,
                           const std::function<double(double time)>& lifetime);

}  // namespace ocean
