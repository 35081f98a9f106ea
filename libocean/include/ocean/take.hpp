// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Takes: a take is a recorded performance, the changes of live parameters over time. It is part of
// the sea.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "ocean/parameter_table.hpp"

namespace ocean {

/// An event: the parameter glides to `value`, a number or a word, from `seconds` [s] on.
struct TakeEvent {
    double seconds = 0.0;
    ParameterRef parameter;
    ParameterValue value;
};

/// Events ordered by time; events of one time stand in the order of the file.
struct Take {
    std::vector<TakeEvent> events;
    /// The value of `time.take` for which the events were read.
    std::string file;

    bool empty() const { return events.empty(); }
};

/// Enough for nine minutes of a knob that moves all the time, at 60 changes a second; inlined, so
/// many events fit a sea file.
inline constexpr std::size_t kMaxTakeEvents = 32768;
inline constexpr std::size_t kMaxTakeBytes = std::size_t{2} << 20;  // size as text
/// Min time between performed events of one parameter [s]. An earlier value is delayed, and the
/// last one replaces the others.
inline constexpr double kMinEventSpacing = 1.0 / 60.0;

/// Returns an event as a line without its end: the full path, and the shortest numbers that read
/// back to the same bits.
std::string take_line(const TakeEvent& event);

}  // namespace ocean
