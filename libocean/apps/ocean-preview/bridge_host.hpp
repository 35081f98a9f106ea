// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A bridge in the preview's own process, which the panel starts and stops: boards and clients
// connect to it as to ocean-bridge.
#pragma once

#include <deque>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "ocean/internal/bridge/endpoint.hpp"
#include "ocean/sea.hpp"

namespace ocean::app {

struct BridgeHostOptions {
    std::string listen = "127.0.0.1:4747";
    std::string token = {};  // "": none, which only a loopback address may have
    std::string map = {};    // a file of control maps; "": the default map
    bool dummy = false;      // a simulated board in place of those on USB
};

class BridgeHost {
  public:
    BridgeHost();
    ~BridgeHost();

    /// Starts the bridge with the values of a sea. Throws Error, and no bridge runs then.
    void start(const BridgeHostOptions& options, const Sea& sea);
    /// Disconnects all clients. Does nothing if no bridge runs.
    void stop();
    bool is_running() const { return running_ != nullptr; }
    /// Returns the address of the running bridge for clients on this machine.
    bridge::Endpoint endpoint() const;
    /// Returns connections, lines and events, of earlier bridges too, the newest last.
    std::vector<std::string> log() const;

  private:
    struct Running;

    void add(std::string line);

    mutable std::mutex mutex_;  // of the log
    std::deque<std::string> log_;
    std::unique_ptr<Running> running_;
};

}  // namespace ocean::app
