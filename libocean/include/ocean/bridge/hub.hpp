// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Boards, the map, the values and the take, joined: what is asked goes in, what has changed comes
// out. No sockets and no threads of its own; whoever serves it calls it from one thread.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/bridge/mapping.hpp"
#include "ocean/bridge/source.hpp"
#include "ocean/bridge/value_table.hpp"
#include "ocean/sea.hpp"

namespace ocean::bridge {

/// The live changes of a recording as a take, in the time of the sea from its start on.
class TakeRecorder {
  public:
    TakeRecorder(double start, Clock::time_point now) : start_(start), began_(now) {}

    /// Changes of a parameter that come faster than a take holds them are thinned: the last one
    /// counts. False when the take is full.
    bool add(const ParameterRef& parameter, const ParameterValue& value, Clock::time_point now);
    /// The take as text, which ocean::parse_take reads.
    std::string text() const;
    bool empty() const { return take_.empty(); }

  private:
    double start_;
    Clock::time_point began_;
    Take take_;
    std::size_t bytes_ = 0;
};

struct HubOptions {
    Sea sea = {};
    std::string map = {};          // a file, read again when it changes
    std::string map_text = {};     // in its place where there is none
    std::string take_folder = {};  // where recordings go; "" = the current one
    /// Boards of a map that has no [[device]].
    std::vector<DeviceRule> devices = {};
};

class Hub {
  public:
    /// With the map's boards beside `sources`. Throws Error for a map that is wrong.
    Hub(HubOptions options, std::vector<std::unique_ptr<Source>> sources);
    ~Hub();

    /// The sources begin; the listener is theirs.
    void start(const Source::Listener& listener);
    void stop();

    const ValueTable& values() const { return values_; }
    std::vector<Channel> channels() const;
    /// What has happened since the last call, a line each, for people and clients.
    std::vector<std::string> events();

    // All of these throw Error, after which nothing has changed.
    void set(std::string_view name, std::string_view value, std::string_view writer);
    void out(const std::string& channel, double value);
    /// A recording begins or ends. `file` is a name without a folder, "" one that is free. While a
    /// client is there that shows the sea (it told app.frame_rate), that one records, in its time.
    void start_recording(const std::string& file, std::string_view writer);
    void stop_recording(const std::string& file, std::string_view writer);

    // Events of the world; nothing is thrown.
    void report(const Report& report);
    /// Its text is one of the next events().
    void board_event(const BoardEvent& event);
    void advance(Clock::time_point now);
    std::optional<Clock::time_point> next() const { return mapping_->next(); }
    /// Every second or so: the map's file may have changed.
    void look_around();
    /// Whether the value is of the program, such as the clock, and that client the one that shows
    /// the sea: it tells how the value stands, where others say how it shall.
    bool is_told_by(std::size_t entry, std::string_view client) const;
    void client_left(std::string_view writer);
    /// A recording that runs is written.
    void finish();

  private:
    void apply(const std::vector<Setting>& settings, Clock::time_point now);
    void store(std::size_t entry, std::string_view value, std::string_view writer,
               Clock::time_point now);
    void follow_recording(Clock::time_point now);
    void save_take();
    void light_lamps();
    void say(std::string text) { events_.push_back(std::move(text)); }
    std::string free_take_name(const std::string& asked) const;

    HubOptions options_;
    ValueTable values_;
    std::unique_ptr<Mapping> mapping_;
    std::filesystem::file_time_type map_time_{};
    std::vector<DeviceRule> map_devices_;
    std::vector<std::unique_ptr<Source>> sources_;
    std::vector<std::string> events_;
    std::optional<TakeRecorder> recorder_;
    std::string take_name_;  // asked for
    std::size_t record_ = 0;
    std::size_t frame_rate_ = 0;
    std::string last_refusal_;  // of a knob: said once
};

}  // namespace ocean::bridge
