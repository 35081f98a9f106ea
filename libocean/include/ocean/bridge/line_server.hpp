// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The bridge on the network: one thread that serves any number of clients of the line protocol and
// peers of Open Sound Control, and at which the boards' reports arrive.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ocean/bridge/endpoint.hpp"
#include "ocean/bridge/hub.hpp"

namespace ocean::bridge {

/// Open Sound Control by UDP.
struct OscOptions {
    std::optional<Endpoint> listen = {};
    /// Addresses, without ports, that may send there. Empty: all that can reach a loopback
    /// address, and no other address may be listened at.
    std::vector<std::string> allow = {};
    std::vector<Endpoint> to = {};  // are told each change
    std::chrono::milliseconds subscription{60'000};

    bool operator==(const OscOptions&) const = default;
};

struct ServerOptions {
    Endpoint listen = {};
    std::string token = {};  // "" = none is asked for, which only a loopback address may have
    std::size_t clients = 64;
    std::chrono::milliseconds idle{300'000};    // of a client without subscriptions
    std::chrono::milliseconds stalled{30'000};  // of one that reads nothing
    double commands_per_second = 200.0;         // of one client; what comes faster waits
    OscOptions osc = {};
    /// A line for people: start, connections, each line that came, ends. Must not wait.
    std::function<void(std::string)> log = {};
};

class LineServer {
  public:
    /// Listens from now on; `hub` is this object's until it is stopped. Throws Error invalid_value
    /// for an address that needs a token or a list of who is allowed, unsupported for more clients
    /// than the system allows and for OSC in a build without it, output if a port cannot be had.
    LineServer(ServerOptions options, Hub& hub);
    /// stop().
    ~LineServer();
    LineServer(const LineServer&) = delete;
    LineServer& operator=(const LineServer&) = delete;

    /// With the port that was chosen, if 0 was asked for.
    Endpoint endpoint() const;
    std::optional<Endpoint> osc_endpoint() const;
    std::size_t clients() const;
    /// Ends all connections and the boards, and writes a take that is being recorded. Any thread
    /// but those of the boards; twice is once.
    void stop();

  private:
    class Core;
    std::unique_ptr<Core> core_;
};

}  // namespace ocean::bridge
