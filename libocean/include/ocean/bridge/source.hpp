// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Where reports come from: a board, a controller, a file. The bridge knows its sources by this
// interface alone, so a new kind of board is one class.
#pragma once

#include <chrono>
#include <cstddef>
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
    /// A hand did it just now, on a board that does not say where its controls rest.
    bool moved = false;
};

/// A board came, went, or cannot be had.
struct BoardEvent {
    enum class Kind {
        connected,  // from now on its channels are there; it knows nothing of its lamps
        lost,
        busy,  // it is there, and refused: said once
    };
    Kind kind;
    std::string board;      // its id, "board0"
    std::string text = "";  // what it is, or why; may be empty

    bool operator==(const BoardEvent&) const = default;
};

/// Returns what clients are told: "board0 CONNECTED: K8055 on bus 1, device 2", "midi0 LOST".
std::string event_text(const BoardEvent& event);

class Source {
  public:
    /// Called from any thread of the source; neither function waits.
    struct Listener {
        std::function<void(Report)> report;
        std::function<void(BoardEvent)> event;
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

/// Throws Error invalid_value for a value out of the channel's range.
void require_in_range(const Channel& channel, double value);
/// Which of `channels` is the output of that name, for a value that it takes. Throws Error
/// invalid_value.
std::size_t output_index(const std::vector<Channel>& channels, const std::string& name,
                         double value);

}  // namespace ocean::bridge
