// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Joins boards, control map, values and the take that is recorded: requests and reports go in,
// changed values and events come out. The hub has no sockets and no threads, and is called from
// one thread.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/internal/bridge/control_map.hpp"
#include "ocean/internal/bridge/source.hpp"
#include "ocean/internal/bridge/value_table.hpp"
#include "ocean/sea.hpp"

namespace ocean::bridge {

/// Collects live changes as a take, whose clock is the sea's and begins at `start` [s].
class TakeRecorder {
  public:
    TakeRecorder(double start, Clock::time_point now) : start_(start), began_(now) {}

    /// Adds a change. Changes of one parameter that come faster than a take holds them are thinned
    /// so that the last one is kept. Returns false when the take is full.
    bool add(const ParameterRef& parameter, const ParameterValue& value, Clock::time_point now);
    /// Returns the take as text, which ocean::parse_take reads.
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
    std::string map = {};          // file of a control map, read again when it changes
    std::string map_text = {};     // the control map itself, used if `map` is empty
    std::string take_folder = {};  // folder of recordings; "" is the current one
    /// The boards, if the control map has no [[device]].
    std::vector<DeviceRule> devices = {};
};

class Hub {
  public:
    /// Uses the boards of the control map and `sources`. Throws Error for a map that is wrong, and
    /// for two boards with one name.
    Hub(HubOptions options, std::vector<std::unique_ptr<Source>> sources);
    ~Hub();

    /// Starts all sources. They call `listener` from their own threads.
    void start(const Source::Listener& listener);
    void stop();

    const ValueTable& values() const { return values_; }
    std::vector<Channel> channels() const;
    /// Returns the events since the last call, one line each, as people and clients read them.
    std::vector<std::string> events();

    // Requests of clients. Each throws Error if it is refused, and then changes nothing.
    void set(std::string_view name, std::string_view value, std::string_view writer);
    void out(const std::string& channel, double value);
    /// Begins a recording named `file`, a name without a folder; "" chooses a free name. While a
    /// client is connected that shows the sea (it sets app.frame_rate), that client records, in its
    /// own time.
    void start_recording(const std::string& file, std::string_view writer);
    /// Ends the recording. A `file` that is not "" replaces the name given at the start.
    void stop_recording(const std::string& file, std::string_view writer);

    // Events of boards, clock and connections. None of these throws.
    void report(const Report& report);
    /// Applies the event and appends its line to events().
    void on_board_event(const BoardEvent& event);
    /// Applies values that change with time alone, such as smoothed ones.
    void advance(Clock::time_point now);
    /// Returns when to call advance(), or nothing while no value is on its way.
    std::optional<Clock::time_point> next() const { return control_map_->next(); }
    /// Reads the control map again if its file has changed. Call it about once a second.
    void poll_map_file();
    /// Returns true if `entry` belongs to the application (app.*) and `client` is the program that
    /// shows the sea. Such a client reports the value; other clients request one.
    bool is_owned_by(std::size_t entry, std::string_view client) const;
    /// Returns true if SET name value by `client` is a report that no user has just caused: the
    /// frame rate, which makes a client the one that shows the sea, and its clock or a value that
    /// app.* has already.
    bool is_report(std::string_view name, std::string_view value, std::string_view client) const;
    void client_left(std::string_view writer);
    /// Writes the take if a recording runs.
    void finish();

  private:
    void apply(const std::vector<Setting>& settings, Clock::time_point now);
    /// Records the change that `entry` has just made, or begins or ends the recording.
    void after_change(std::size_t entry, Clock::time_point now);
    void follow_recording(Clock::time_point now);
    void save_take();
    void update_outputs();
    void add_event(std::string text) { events_.push_back(std::move(text)); }
    std::string free_take_name(const std::string& requested) const;

    HubOptions options_;
    ValueTable values_;
    std::unique_ptr<ControlMap> control_map_;
    std::filesystem::file_time_type map_time_{};
    std::vector<DeviceRule> map_devices_;
    std::vector<std::unique_ptr<Source>> sources_;
    std::vector<std::string> events_;
    std::optional<TakeRecorder> recorder_;
    std::string take_name_;  // as requested
    std::size_t record_ = 0;
    std::size_t frame_rate_ = 0;
    std::string last_refusal_;  // of a control; reported once
};

}  // namespace ocean::bridge
