// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The growing take; see performer.hpp.
#include "waves/state/performer.hpp"

#include <algorithm>
#include <limits>
#include <string>
#include <variant>

#include "ocean/error.hpp"

namespace ocean {

namespace {

Error refused(const std::string& message) {
    return Error(ErrorKind::invalid_value, message);
}

/// Returns the event for a value, checked against its range.
TakeEvent checked_event(const Sea& sea, double time, std::string_view name,
                        std::string_view value) {
    TakeEvent event{time, find_parameter(name), {}};
    const ParameterInfo& info = *event.parameter.info;
    const std::string path = info.path(event.parameter.item);
    if (info.change != ParameterClass::live) {
        throw refused(path + " is not live: it can be set, but not performed; allowed: " +
                      live_parameter_names());
    }
    if (sea.parameters.time.loop_period > 0.0) {
        throw refused("time.loop_period = " + to_text(sea.parameters.time.loop_period) +
                      " s: a sea with a loop cannot be performed; allowed: 0");
    }
    Parameters set = sea.parameters;
    set_parameter(set, name, value);
    event.value = value_of(set, event.parameter);
    if (info.type() == "float" && std::holds_alternative<std::string>(event.value)) {
        throw refused(path + ": has no value to glide to; allowed: a number");
    }
    return event;
}

}  // namespace

Performer::Performer(const Sea& sea)
    : last_(sea.take.empty() ? -std::numeric_limits<double>::infinity()
                             : sea.take.events.back().seconds),
      bytes_(0) {
    for (const TakeEvent& event : sea.take.events) bytes_ += take_line(event).size() + 1;
}

double Performer::perform(Sea& sea, double time, std::string_view name, std::string_view value) {
    require_time(time);
    TakeEvent event = checked_event(sea, time, name, value);
    if (time < last_) {
        throw refused("time = " + to_text(time) + " s: is before the last performed event, at " +
                      to_text(last_) + " s; allowed: that time or later");
    }
    std::vector<TakeEvent>& events = sea.take.events;
    const auto before = std::find_if(events.rbegin(), events.rend(), [&](const TakeEvent& other) {
        return other.parameter.same_as(event.parameter);
    });
    const auto performed = [&](double from) {
        last_ = time;
        return from;
    };
    if (before != events.rend() && before->value == event.value) {
        return performed(std::numeric_limits<double>::infinity());
    }
    if (before != events.rend() && before->seconds > time) {
        // The previous event still waits for its time and has not been shown, so that it is
        // replaced.
        bytes_ -= take_line(*before).size();
        before->value = event.value;
        bytes_ += take_line(*before).size();
        return performed(before->seconds);
    }
    if (before != events.rend()) {
        event.seconds = std::max(time, before->seconds + kMinEventSpacing);
    }
    const std::size_t bytes = bytes_ + take_line(event).size() + 1;
    if (events.size() >= kMaxTakeEvents || bytes > kMaxTakeBytes) {
        throw refused("the take is full: it has " + std::to_string(events.size()) +
                      " events; allowed: " + std::to_string(kMaxTakeEvents) +
                      " in 2 MiB. Save it and begin another");
    }
    const double from = event.seconds;
    const auto after = std::upper_bound(
        events.begin(), events.end(), from,
        [](double seconds, const TakeEvent& other) { return seconds < other.seconds; });
    events.insert(after, std::move(event));
    bytes_ = bytes;
    return performed(from);
}

}  // namespace ocean
