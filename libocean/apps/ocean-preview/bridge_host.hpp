// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A bridge in the preview's own process, which a person starts and stops in the panel: boards and
// clients come to it as to ocean-bridge.
#pragma once

#include <deque>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "ocean/bridge/endpoint.hpp"
#include "ocean/sea.hpp"

namespace ocean::app {

struct BridgeHostOptions {
    std::string listen = "127.0.0.1:4747";
    std::string token = {};  // "" = none, which only a loopback address may have
    std::string map = {};    // a file; "" = the usual one
    bool dummy = false;      // a board that is not there, instead of those on USB
};

class BridgeHost {
  public:
    BridgeHost();
    ~BridgeHost();

    /// With the values of a sea. Throws Error, and is stopped then.
    void start(const BridgeHostOptions& options, const Sea& sea);
    /// Lets all clients go; twice is once.
    void stop();
    bool is_running() const { return running_ != nullptr; }
    /// Of one that runs: where it is joined from this machine.
    bridge::Endpoint endpoint() const;
    /// Connections, lines and events, also of those before; the newest last.
    std::vector<std::string> log() const;
    /// This client's clock, told twice a second, stays out of the log.
    void leave_out_clock_of(const std::string& client);

  private:
    struct Running;

    void add(std::string line);

    mutable std::mutex mutex_;  // of the log
    std::deque<std::string> log_;
    std::string left_out_;  // what such a line begins with
    std::unique_ptr<Running> running_;
};

}  // namespace ocean::app
