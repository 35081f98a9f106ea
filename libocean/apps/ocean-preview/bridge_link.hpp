// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The connection of a sea to a bridge: values that a knob or another client sets there change the
// sea here, and changes here are sent there.
#pragma once

#include <array>
#include <chrono>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "live_sea.hpp"
#include "ocean/internal/bridge/line_client.hpp"

namespace ocean::app {

/// Calls that the bridge causes; the link itself applies its clock and its parameters to the sea.
struct BridgeCalls {
    /// Starts or stops recording. name: of the take; "" leaves it open.
    std::function<void(bool on, const std::string& name)> record;
    /// Drives a hull of that number from 1, or none (0), as a hand does; empty: the link does it.
    /// Throws Error.
    std::function<void(std::size_t number)> drive = {};
    /// Receives each line of the log at once; may be empty.
    std::function<void(const std::string& line)> logged = {};
};

class BridgeLink {
  public:
    BridgeLink(const bridge::LineClientOptions& options, BridgeCalls calls);

    /// Applies the values that clients of the bridge have set since the last call. Values that the
    /// bridge has from its start are not applied: the sea's are sent to it. When the connection is
    /// lost the sea stays as it is. Returns whether the sea has changed.
    bool apply(LiveSea& sea);
    /// Waits for events of the bridge, at most `longest`, and applies them like apply().
    bool wait_and_apply(LiveSea& sea, std::chrono::milliseconds longest);
    /// Sends a parameter of the sea that was changed here, or a value of the application.
    void send(const std::string& name, const std::string& value);
    /// Sends all parameters that the bridge has other values of; `moved_too`: also those that its
    /// clients have set.
    void send_values(const LiveSea& sea, bool moved_too);
    /// Sends the sea's clock and the frames a second, twice a second. Of several windows the first
    /// one sends its clock, and the clocks of the others follow it.
    void send_clock(const LiveSea& sea, double frame_rate);

    bool connected() const { return client_.connected(); }
    /// Returns whether the bridge is connected and all of its values have arrived.
    bool joined() const { return connected() && values_known_; }
    /// Returns who has set each value: "waves.0.wind_speed": "board0/a1".
    const std::map<std::string, std::string>& movers() const { return movers_; }
    /// Returns the name of this program among them, "" before it has joined.
    const std::string& own_name() const { return own_names_.back(); }
    /// Returns lines of the bridge and refusals, the newest last, kMaxLines at most.
    const std::vector<std::string>& log() const { return log_; }
    std::vector<std::string> extract_log() { return std::exchange(log_, {}); }

    static constexpr std::size_t kMaxLines = 200;

  private:
    bool apply_events(LiveSea& sea, const std::vector<bridge::ClientEvent>& events);
    bool apply_value(LiveSea& sea, const std::string& name, const std::string& value);
    bool apply_hull_value(LiveSea& sea, const std::string& name, const std::string& value);
    void drive(LiveSea& sea, std::size_t number) const;
    void send_hull(const LiveSea& sea);
    std::string mover(const std::string& name) const;
    bool is_own(const std::string& writer) const;
    /// Returns whether another window sends the bridge's clock.
    bool another_shows() const;
    void note_recording(const std::string& event);
    void add_to_log(std::string text);

    bridge::LineClient client_;
    BridgeCalls calls_;
    std::map<std::string, std::string> values_;  // as the bridge has them
    std::map<std::string, std::string> sent_;    // as they were sent last
    std::map<std::string, std::string> movers_;
    std::array<std::string, 2> own_names_;  // in the previous connection and in this one
    std::string take_name_;
    std::vector<std::string> log_;
    bool applying_ = false;
    bool noted_rebuild_ = false;
    std::chrono::steady_clock::time_point clock_sent_{};
    std::chrono::steady_clock::time_point joined_{};
    bool values_known_ = false;
};

}  // namespace ocean::app
