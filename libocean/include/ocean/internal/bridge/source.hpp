// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The interface of everything that reports: a board, a controller, a file. The bridge knows its
// sources by this interface alone.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace ocean::bridge {

/// The clock of reports and of everything computed from them. It is never set back.
using Clock = std::chrono::steady_clock;

/// One wire of a board: an input (knob, button, counter) or an output (lamp, voltage).
struct Channel {
    std::string name;  // "board0/a1"
    double min = 0.0;
    double max = 255.0;
    bool output = false;
};

/// Returns true for "BOARD/LETTERSdigits", such as "board0/a1": BOARD has lower-case letters,
/// digits and '_'; either part has at most 32 bytes.
bool is_channel_name(std::string_view name);

/// The value of a channel at a time, in units of the board. A source may repeat a value that has
/// not changed.
struct Report {
    Clock::time_point time;
    std::string channel;
    double value = 0.0;
    /// The user moved the control just now (the board does not report initial positions).
    bool moved = false;
};

/// A board has connected, is lost, or cannot be opened.
struct BoardEvent {
    enum class Kind {
        connected,  // its channels are available from now on; its outputs have no known value
        lost,
        busy,  // it is plugged in but refused; reported once
    };
    Kind kind;
    std::string board;      // its id, "board0"
    std::string text = "";  // description of the board, or the reason; may be empty

    bool operator==(const BoardEvent&) const = default;
};

/// Returns the event as clients read it: "board0 CONNECTED: K8055 on bus 1, device 2",
/// "midi0 LOST".
std::string event_text(const BoardEvent& event);

class Source {
  public:
    /// The functions are called from threads of the source. They must not block.
    struct Listener {
        std::function<void(Report)> report;
        std::function<void(BoardEvent)> event;
    };

    virtual ~Source() = default;
    /// Returns the channels that are available now. Any thread.
    virtual std::vector<Channel> channels() const = 0;
    /// Begins to report. If the board reports positions, each input's position comes first.
    virtual void start(Listener listener) = 0;
    /// Ends the reports: after its return `listener` is not called. It may be called before start
    /// and again.
    virtual void stop() = 0;
    /// Requests a value of an output, which the board gets as soon as possible. Returns at once;
    /// any thread. Throws Error invalid_value for a channel that is not an output, and for a value
    /// out of range.
    virtual void put(const std::string& channel, double value) = 0;
};

/// Returns the channel of that name, or nullptr.
const Channel* find_channel(const std::vector<Channel>& channels, std::string_view name);

/// Throws Error invalid_value for a value out of the channel's range.
void require_in_range(const Channel& channel, double value);
/// Returns the index in `channels` of the output of that name. Throws Error invalid_value if
/// `channels` has no such output, or if the value is out of its range.
std::size_t output_index(const std::vector<Channel>& channels, const std::string& name,
                         double value);

}  // namespace ocean::bridge
