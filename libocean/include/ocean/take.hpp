// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A take: a recorded performance, the changes of live parameters over time. Part of the sea.
#pragma once

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

}  // namespace ocean
