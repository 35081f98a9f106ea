// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// When foam is: the ticks of its clock, and how far back it must be followed.
#pragma once

#include <cstdint>
#include <functional>

#include "ocean/parameters.hpp"

namespace ocean {

/// The foam's own clock: ticks n * step from t = 0, whatever the frame rate. In a loop the step is
/// foam_step rounded so that a loop is a whole number of ticks, and ticks are numbered within it.
struct FoamClock {
    double step = 0.05;               // s
    double loop_period = 0.0;         // s; 0 = no loop
    std::int64_t ticks_per_loop = 0;  // 0 = no loop

    bool operator==(const FoamClock&) const = default;

    /// The last tick at or before a time, and the seconds since it.
    struct Moment {
        std::int64_t tick;
        double since;
    };
    Moment moment(double time) const;
    double time_of(std::int64_t tick) const;
    /// How many ticks `to` is after `from`: in a loop 0 .. ticks_per_loop - 1.
    std::int64_t ticks_between(std::int64_t from, std::int64_t to) const;
    /// The tick `count` ticks before; count may be negative.
    std::int64_t before(std::int64_t tick, std::int64_t count) const;
};
FoamClock foam_clock(const SurfaceSettings& settings, double loop_period);

enum class FoamStart {
    settled,  // from as far back as foam lives: the same bits as from any earlier start
    empty,    // from nothing, for live tools: right after settling_ticks()
};

/// How many ticks before `tick` foam must be followed from, to the same bits as from any earlier
/// start: ceil(ln(512) lifetime / step) and a little for the rounding of floats, at most one loop,
/// and where the lifetime changes, as many as make foam fade to 1/512.
std::int64_t preroll_ticks(const FoamClock& clock, std::int64_t tick,
                           const std::function<double(double time)>& lifetime);

}  // namespace ocean
