// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Beside the mapping: what a hand does with a control, written as the [[map]] that fits it. It
// tells faders, endless knobs, values of 14 bits, buttons and counters apart. Pure; time is that of
// the reports.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/bridge/source.hpp"
#include "ocean/bridge/value_table.hpp"

namespace ocean::bridge {

/// What was learnt of a control that has come to rest.
struct Lesson {
    bool is_map = false;  // lines of a map; else a hint for the hand, one line
    std::string text;
};

class Learner {
  public:
    /// The maps turn `to`, over what its slider offers; "" is wind_speed, and app.pause for
    /// buttons. Throws Error not_found for an unknown name, invalid_value for one that is no
    /// number.
    explicit Learner(const ValueTable& values, const std::string& to = "");

    /// `channel` is the report's, where the source lists it.
    void report(const Report& report, const Channel* channel);
    /// Returns what has come to rest, in the order of the channels' names. A control that has not
    /// moved enough to be told from others is hinted at, once, and what it did still counts.
    std::vector<Lesson> advance(Clock::time_point now);
    /// When to advance next; nothing while all rests.
    std::optional<Clock::time_point> next() const;

  private:
    /// What one channel has said since it was last learnt.
    struct Gesture {
        std::vector<double> values;
        std::optional<double> rest;  // of a board that says where its controls are
        std::array<double, 2> range{};
        std::size_t coarse_then_fine = 0;  // of either controller of a pair
        bool hinted = false;
    };
    /// The channels of one controller of MIDI, or one channel of another board: a hand moves one
    /// control at a time, which may be several channels.
    struct Group {
        std::map<std::string, Gesture> gestures;
        std::string latest;  // controller
        std::optional<Clock::time_point> moved;
    };
    struct Target {
        std::string name;
        std::array<double, 2> out;
    };

    void learn(Group& group, std::vector<Lesson>& lessons);
    /// The map's lines, nothing of a channel that has not moved enough.
    std::optional<std::string> map_of(const std::string& channel, const Gesture& gesture) const;
    std::string lines(const std::string& channel, const Target& target,
                      const std::string& more) const;

    Target knob_;
    Target button_;
    std::string step_;  // of the knob's value, for a counter
    std::map<std::string, Group> groups_;
    std::string told_;
};

}  // namespace ocean::bridge
