// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A take: a recorded performance, the changes of live parameters over time. Part of the sea.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "ocean/parameter_table.hpp"

namespace ocean {

/// From `seconds` on the parameter glides to `value`: a number, or one of the parameter's words.
struct TakeEvent {
    double seconds = 0.0;
    ParameterRef parameter;
    ParameterValue value;
};

/// In order of time; events at one time in the order of the file.
struct Take {
    std::vector<TakeEvent> events;
    /// The `time.take` that the events were read for.
    std::string file;

    bool empty() const { return events.empty(); }
};

/// Nine minutes of a knob that never rests, at 60 changes a second; inlined they fit a sea file.
inline constexpr std::size_t kMaxTakeEvents = 32768;
inline constexpr std::size_t kMaxTakeBytes = std::size_t{2} << 20;  // as text
/// Of one parameter's live events, s: what comes sooner waits, and the last value counts.
inline constexpr double kLeastEventDistance = 1.0 / 60.0;

/// An event as a line, without its end: full path, shortest numbers that read back to the same
/// bits.
std::string take_line(const TakeEvent& event);

}  // namespace ocean
