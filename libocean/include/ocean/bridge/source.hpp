// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Where reports come from: a board, a controller, a file. The bridge knows its sources by this
// interface alone, so a new kind of board is one class.
#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace ocean::bridge {

/// Of reports and all that is reckoned from them; never set back.
using Clock = std::chrono::steady_clock;

/// One wire of a board: a knob, a button, a counter; a lamp or a voltage if it is an output.
struct Channel {
    std::string name;  // "board0/a1"
    double lowest = 0.0;
    double highest = 255.0;
    bool output = false;
};

/// "BOARD/LETTERSdigits", such as "board0/a1": small letters, digits and '_', 32 bytes a part.
bool is_channel_name(std::string_view name);

/// What a channel was at a time, in the board's own units. Whether a channel that rests is reported
/// again and again or only when it moves is the board's business.
struct Report {
    Clock::time_point time;
    std::string channel;
    double value = 0.0;
};

class Source {
  public:
    /// Called from any thread of the source; neither function waits.
    struct Listener {
        std::function<void(Report)> report;
        /// "board0 LOST", "board0 BACK": what clients are told.
        std::function<void(std::string)> event;
    };

    virtual ~Source() = default;
    /// Those it has now; any thread.
    virtual std::vector<Channel> channels() const = 0;
    /// Reports come from now on, that of each input's place first, where the board tells it.
    virtual void start(Listener listener) = 0;
    /// When it returns the listener is not called any more. Also before start, and twice.
    virtual void stop() = 0;
    /// An output takes the value as soon as the board does; does not wait for it, any thread.
    /// Throws Error invalid_value for a channel that cannot be told, and for a value out of range.
    virtual void put(const std::string& channel, double value) = 0;
};

/// Of `channels` the one of that name; nullptr if it is not there.
const Channel* find_channel(const std::vector<Channel>& channels, std::string_view name);

}  // namespace ocean::bridge
