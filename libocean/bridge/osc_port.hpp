// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Open Sound Control by UDP, in the thread of the line server: messages that come set values or ask
// for them; whoever is to be told the changes gets bundles, at most 60 times a second, without what
// came from there. Nothing of it grows with what strangers send.
#pragma once

#include <asio.hpp>
#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/bridge/line_server.hpp"
#include "osc_message.hpp"

namespace ocean::bridge {

/// Throws Error invalid_value or unsupported.
void require_valid(const OscOptions& options);

class OscPort {
  public:
    /// What it needs of the server.
    struct Host {
        Hub& hub;
        std::function<void(std::string)> log;
        /// Values or events may be new.
        std::function<void()> changed;
    };

    /// Of valid options. Throws Error output if a port cannot be had.
    OscPort(asio::io_context& io, const OscOptions& options, Host host);

    /// Where it listens, if it does. Any thread.
    const std::optional<Endpoint>& endpoint() const { return endpoint_; }
    /// Sends what is new, now or as soon as the rate allows.
    void update();
    /// What has gone on for too long.
    void look_around(Clock::time_point now);
    void close();

  private:
    using Udp = asio::ip::udp;

    /// Who is told the changes.
    struct Target {
        Udp::endpoint endpoint;
        std::string writer;  // the name of what it sets
        std::optional<Clock::time_point> expires = {};
        bool has_snapshot = false;
        std::uint64_t told = 0;  // revision
        bool fails = false;
    };

    /// Whether an address comes for the first time, for the log: of the first few that come.
    class FirstTimes {
      public:
        bool is_first(const asio::ip::address& address);

      private:
        std::set<asio::ip::address> seen_;
    };

    void listen(const Endpoint& wanted);
    void receive();
    void take(std::string_view packet);
    void obey(const OscMessage& message);
    void subscribe(const OscMessage& message);
    void complain(const std::string& why);
    bool is_allowed(const asio::ip::address& address) const;

    void tell_all();
    /// False if the system does not take it.
    bool tell(Target& target);
    OscArgument argument_of(std::size_t entry) const;
    void send(std::string_view packet, const Udp::endpoint& to, asio::error_code& error);
    Udp::socket& socket_for(const Udp::endpoint& to);

    asio::io_context& io_;
    const Host host_;
    const std::set<asio::ip::address> allowed_;
    const Clock::duration subscription_;
    std::optional<Endpoint> endpoint_;
    Udp::socket in_;
    std::vector<Udp::socket> out_;  // for targets that `in_` does not reach
    std::vector<char> packet_;
    Udp::endpoint sender_;  // of the packet
    std::string writer_;    // its name
    std::vector<Target> targets_;
    asio::steady_timer timer_;
    bool waits_ = false;  // for the timer
    Clock::time_point sent_{};

    FirstTimes senders_;
    FirstTimes strangers_;
    std::uint64_t dropped_ = 0;  // packets
    Clock::time_point quiet_until_{};
    Clock::duration quiet_{};
    std::uint64_t unsaid_ = 0;  // complaints
};

}  // namespace ocean::bridge
