// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The bridge on the network: one thread serves all clients of the line protocol and all peers of
// Open Sound Control, and processes the boards' reports.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ocean/internal/bridge/endpoint.hpp"
#include "ocean/internal/bridge/hub.hpp"

namespace ocean::bridge {

/// Open Sound Control by UDP.
struct OscOptions {
    std::optional<Endpoint> listen = {};
    /// Addresses, without ports, that may send to `listen`. If empty, `listen` must be a loopback
    /// address, and every program of this machine may send.
    std::vector<std::string> allow = {};
    std::vector<Endpoint> to = {};  // receive each change
    std::chrono::milliseconds subscription{60'000};

    bool operator==(const OscOptions&) const = default;
};

struct ServerOptions {
    Endpoint listen = {};
    std::string token = {};    // "" requires none; allowed for a loopback address alone
    std::size_t clients = 64;  // max number of connections
    std::chrono::milliseconds idle{300'000};    // limit for a silent client without subscriptions
    std::chrono::milliseconds stalled{30'000};  // limit for a client that reads nothing
    double commands_per_second = 200.0;         // limit per client; further commands wait
    OscOptions osc = {};
    /// Receives one line per start, connection, command and end. Must not block.
    std::function<void(std::string)> log = {};
    /// Logs also the reports of the program that shows the sea: its clock and its frame rate, twice
    /// a second, and values of app.* that it repeats. What a user does there is always logged.
    bool log_reports = false;
};

class LineServer {
  public:
    /// Listens at once. `hub` belongs to the server until stop() returns. Throws Error
    /// invalid_value for an address that requires a token or a list of allowed senders, unsupported
    /// for more clients than the system allows and for OSC in a build without liblo, output if a
    /// port is not available.
    LineServer(ServerOptions options, Hub& hub);
    /// Calls stop().
    ~LineServer();
    LineServer(const LineServer&) = delete;
    LineServer& operator=(const LineServer&) = delete;

    /// Returns the address with the port in use, which the system chooses for port 0.
    Endpoint endpoint() const;
    std::optional<Endpoint> osc_endpoint() const;
    std::size_t clients() const;
    /// Ends all connections, stops the boards and writes a take that is being recorded. May be
    /// called from any thread except the boards' threads; further calls do nothing.
    void stop();

  private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace ocean::bridge
