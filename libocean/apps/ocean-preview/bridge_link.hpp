// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The sea joined to a bridge: what a knob or another client moves there moves here, and what a
// person moves here is told there.
#pragma once

#include <array>
#include <chrono>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "live_sea.hpp"
#include "ocean/bridge/line_client.hpp"

namespace ocean::app {

/// What the bridge's app.* ask for, beside the clock, which is the sea's.
struct BridgeWishes {
    /// `name` is what the take is to be called, "" anything.
    std::function<void(bool on, const std::string& name)> record;
    /// Called with each line of the log, where somebody reads it at once.
    std::function<void(const std::string& line)> said = {};
};

class BridgeLink {
  public:
    BridgeLink(const bridge::LineClientOptions& options, BridgeWishes wishes);

    /// Applies what has come: values that somebody there has written, not those that it began
    /// with; these are told the sea's. Of a lost bridge what there is holds. Returns whether the
    /// sea changed.
    bool apply(LiveSea& sea);
    /// The same, after waiting for something to come.
    bool wait_and_apply(LiveSea& sea, std::chrono::milliseconds longest);
    /// Of the sea, changed here.
    void tell(const std::string& name, const std::string& value);
    /// All of the sea's that the bridge has otherwise; those too that somebody there has moved.
    void tell_values(const LiveSea& sea, bool moved_too);
    /// Its clock, and how many frames a second are shown: some times a second. Of several windows
    /// the one that came first tells it, and the others' clocks follow.
    void tell_clock(const LiveSea& sea, double frame_rate);

    bool connected() const { return client_.connected(); }
    /// And all of its values have come.
    bool joined() const { return connected() && values_known_; }
    /// "waves.0.wind_speed": "board0/a1".
    const std::map<std::string, std::string>& movers() const { return movers_; }
    /// This program among them, "" before it was joined.
    const std::string& own_name() const { return own_names_.back(); }
    /// What it said and what was refused, the newest last; at most kMostLines.
    const std::vector<std::string>& log() const { return log_; }
    std::vector<std::string> take_log() { return std::exchange(log_, {}); }

    static constexpr std::size_t kMostLines = 200;

  private:
    bool take(LiveSea& sea, const std::vector<bridge::ClientEvent>& events);
    bool take_value(LiveSea& sea, const std::string& name, const std::string& value);
    std::string mover(const std::string& name) const;
    bool is_own(const std::string& writer) const;
    /// The bridge's clock is that of another window.
    bool another_shows() const;
    void hear_of_recording(const std::string& event);
    void say(std::string text);

    bridge::LineClient client_;
    BridgeWishes wishes_;
    std::map<std::string, std::string> values_;  // as the bridge has them
    std::map<std::string, std::string> told_;    // as it was told them last
    std::map<std::string, std::string> movers_;
    std::array<std::string, 2> own_names_;  // of the connection that was lost, and of this one
    std::string take_name_;
    std::vector<std::string> log_;
    bool applying_ = false;
    bool told_of_rebuild_ = false;
    std::chrono::steady_clock::time_point clock_told_{};
    std::chrono::steady_clock::time_point joined_{};
    bool values_known_ = false;
};

}  // namespace ocean::app
