// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The queues of a line client between the program's threads and the thread of its connection:
// events for the program, values and lines to send, and lines whose answers are pending. No
// sockets.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <map>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "ocean/internal/bridge/line_client.hpp"

namespace ocean::bridge {

/// The events that the program has not taken yet: every line, and the latest change of each value.
class ClientEvents {
  public:
    bool empty() const { return events_.empty(); }
    /// Removes and returns all events, in order.
    std::vector<ClientEvent> take();
    /// Adds an event. A value replaces the value before it, unless its writer has changed in
    /// between: then the latest value of each writer is kept. Beyond a limit the oldest other line
    /// is dropped.
    void add(ClientEvent event);
    /// Removes the values of a name.
    void drop_values(const std::string& name);

  private:
    void keep_one_of(const std::string& name);
    void index_values();

    std::vector<ClientEvent> events_;
    std::map<std::string, std::size_t> value_at_;  // index in events_ of a name's latest value
    std::set<std::string> rewritten_;  // names whose writer has changed since their latest value
    std::size_t line_count_ = 0;
};

/// Returns the full path of a parameter, which the program and the bridge may name in two ways. A
/// name of app.* and an unknown name are returned as they are.
std::string full_name(const std::string& name);

/// All functions may be called from any thread.
class ClientQueues {
  public:
    // ---- For the program.
    bool is_connected() const;
    std::vector<ClientEvent> events();
    std::vector<ClientEvent> wait(std::chrono::milliseconds limit);
    // Both return true if the connection's thread must be woken to send.
    bool set(const std::string& name, const std::string& value, bool is_request);
    bool send(const std::string& line);

    // ---- For the connection's thread.
    void deliver(ClientEvent event);
    void connected();
    /// Empties the queues of a lost connection. Values without an answer are sent again later,
    /// unless a newer value of the name waits. Returns true if the connection was established.
    bool disconnected();
    /// Notes that a line is sent whose answer the program does not see.
    void expect_silent_answer();
    /// Removes the oldest pending line. Returns true if the program sees its answer.
    bool answered();
    /// Returns the lines to send now, each with its end. A name has one value on its way at a time,
    /// so that a busy bridge gets the latest value and not all of them.
    std::string take_lines();
    void woken();

  private:
    /// A line whose answer is pending.
    struct PendingLine {
        enum class Kind { value, silent, reply };
        Kind kind;
        std::string name = {};  // of the value
        std::string value = {};
    };
    bool is_pending(const std::string& name) const;
    bool needs_wake();

    mutable std::mutex mutex_;
    std::condition_variable arrived_;
    bool is_connected_ = false;
    bool woken_ = false;
    ClientEvents events_;
    std::set<std::string> reported_;  // names whose last value was reported, not requested
    std::map<std::string, std::string> wanted_;  // values to send, by name
    std::deque<std::string> lines_;              // lines to send
    std::deque<PendingLine> pending_;
};

}  // namespace ocean::bridge
