// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Writes the [[map]] that fits a control from the way a hand moves it. It distinguishes faders,
// endless knobs, values of 14 bits, buttons and counters. A pure state machine: reports bring their
// own time.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/internal/bridge/source.hpp"
#include "ocean/internal/bridge/value_table.hpp"

namespace ocean::bridge {

/// The result for a control that has come to rest.
struct Lesson {
    bool is_map = false;  // true: lines of a control map; false: a hint for the user, one line
    std::string text;
};

class Learner {
  public:
    /// The maps set the value `to` over the range of its slider. Without a name knobs set
    /// wind_speed, and buttons app.pause. Throws Error not_found for an unknown name, invalid_value
    /// for a value that is not a number.
    explicit Learner(const ValueTable& values, const std::string& to = "");

    /// `channel` is the channel that the source lists for the report, or nullptr.
    void report(const Report& report, const Channel* channel);
    /// Returns a lesson for each control that has come to rest, sorted by channel. A control that
    /// has not moved enough to be identified gets one hint, and its movement still counts.
    std::vector<Lesson> advance(Clock::time_point now);
    /// Returns when to call advance(), or nothing while all controls rest.
    std::optional<Clock::time_point> next() const;

  private:
    /// The values of one channel since the channel was last learnt.
    struct Gesture {
        std::vector<double> values;
        std::optional<double> rest;  // position, if the board reports positions
        std::array<double, 2> range{};
        std::size_t coarse_then_fine = 0;  // count for either controller of a pair
        bool hinted = false;
    };
    /// All channels of one MIDI controller, or one channel of another board: a hand moves one
    /// control at a time, which may be several channels.
    struct Group {
        std::map<std::string, Gesture> gestures;
        std::string latest_controller;
        std::optional<Clock::time_point> moved;
    };
    struct Target {
        std::string name;
        std::array<double, 2> out;
    };

    void learn(Group& group, std::vector<Lesson>& lessons);
    /// Returns the map's lines, or nothing for a channel that has not moved enough.
    std::optional<std::string> map_of(const std::string& channel, const Gesture& gesture) const;
    std::string lines(const std::string& channel, const Target& target,
                      const std::string& more) const;

    Target knob_;
    Target button_;
    std::string step_;  // of the knob's value, for counters and endless knobs
    std::map<std::string, Group> groups_;
    std::string last_map_;
};

}  // namespace ocean::bridge
