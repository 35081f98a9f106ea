// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A program's end of the line protocol: a thread keeps the connection, reconnects when the bridge
// is back, and stores events until the program takes them.
#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "ocean/internal/bridge/endpoint.hpp"

namespace ocean::bridge {

struct LineClientOptions {
    Endpoint server = {};
    std::string token = {};  // "" for a bridge without one
    bool subscribe = true;
    std::vector<std::string> names = {};  // values to subscribe to; empty for all
};

/// A line of the bridge, or a change of the connection. Names are full paths.
struct ClientEvent {
    enum class Kind {
        connected,  // name: this client's name at the bridge; text: the greeting; values follow
        lost,       // text: the reason; values stay as they are, and the client tries again
        value,      // name, text: a value of the snapshot, or a change
        writer,     // name, text: the new writer of the value
        notice,     // text: an event of the bridge, such as "TAKE take_1.take"
        refused,    // text: "CODE ...", the answer to a refused line
        reply,      // text: any other line
    };
    Kind kind;
    std::string name = {};
    std::string text = {};
};

/// Every function may be called from any thread. No function but wait() blocks.
class LineClient {
  public:
    explicit LineClient(LineClientOptions options);
    ~LineClient();
    LineClient(const LineClient&) = delete;
    LineClient& operator=(const LineClient&) = delete;

    bool connected() const;
    /// Returns the events since the last call, in order. Several changes of a value become the
    /// latest one; if two writers have changed it in turn, the latest change of each. While a set()
    /// is not yet confirmed, older values of that name are left out.
    std::vector<ClientEvent> events();
    /// Blocks until an event is available or the time is over, then returns events().
    std::vector<ClientEvent> wait(std::chrono::milliseconds limit);

    /// Requests a value. Of several requests for one name the latest is sent, when the connection
    /// is back if it is lost.
    void set(const std::string& name, const std::string& value);
    /// Reports the state of a value of this program. Unlike set(), it does not hide a value that
    /// another client requests meanwhile.
    void report(const std::string& name, const std::string& value);
    /// Sends a line as it is. Without a connection the line is dropped.
    void send(const std::string& line);

  private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace ocean::bridge
