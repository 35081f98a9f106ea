// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Open Sound Control by UDP, in the thread of the line server. Messages set values or ask for them;
// targets receive the changes of others in bundles, at most 60 times per second. No memory grows
// with the packets of unknown senders.
#pragma once

#include <asio.hpp>
#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/internal/bridge/line_server.hpp"
#include "osc_message.hpp"

namespace ocean::bridge {

/// Throws Error invalid_value for options that are wrong, unsupported in a build without liblo.
void require_valid(const OscOptions& options);

class OscPort {
  public:
    /// The server's part of the port.
    struct Host {
        Hub& hub;
        std::function<void(std::string)> log;
        /// To be called after everything that may have changed a value or made an event.
        std::function<void()> changed;
    };

    /// `options` must be valid. Throws Error output if a port is not available.
    OscPort(asio::io_context& io, const OscOptions& options, Host host);

    /// Returns the address that the port listens at, or nothing. Any thread.
    const std::optional<Endpoint>& endpoint() const { return endpoint_; }
    /// Sends the changes, now or as soon as the rate allows.
    void update();
    /// Ends the subscriptions that have expired.
    void end_subscriptions(Clock::time_point now);
    void close();

  private:
    using Udp = asio::ip::udp;

    /// A receiver of changes.
    struct Target {
        Udp::endpoint endpoint;
        std::string writer;  // its name as a writer of values
        std::optional<Clock::time_point> expires = {};
        bool has_snapshot = false;
        std::uint64_t sent = 0;  // revision of the last bundle
        bool fails = false;
    };

    /// The first few addresses, each of which the log names once.
    class FirstAddresses {
      public:
        /// Returns true for a new address while there is room for more.
        bool add(const asio::ip::address& address);

      private:
        std::set<asio::ip::address> seen_;
    };

    void listen(const Endpoint& wanted);
    void receive();
    void handle_packet(std::string_view packet);
    void handle(const OscMessage& message);
    void subscribe(const OscMessage& message);
    void log_problem(const std::string& problem);
    bool is_allowed(const asio::ip::address& address) const;

    void send_changes();
    /// Returns false if the system refuses a packet.
    bool send_changes(Target& target);
    OscArgument argument_of(std::size_t entry) const;
    void send(std::string_view packet, const Udp::endpoint& to, asio::error_code& error);
    Udp::socket& socket_for(const Udp::endpoint& to);

    asio::io_context& io_;
    const Host host_;
    const std::set<asio::ip::address> allowed_;
    const Clock::duration subscription_;
    std::optional<Endpoint> endpoint_;
    Udp::socket in_;
    std::vector<Udp::socket> out_;  // for targets of another protocol than in_
    std::vector<char> packet_;
    Udp::endpoint sender_;  // of packet_
    std::string writer_;    // the sender's name as a writer of values
    std::vector<Target> targets_;
    asio::steady_timer timer_;
    bool is_waiting_ = false;  // for the timer
    Clock::time_point sent_{};

    FirstAddresses senders_;
    FirstAddresses strangers_;
    std::uint64_t dropped_ = 0;  // packets of strangers
    Clock::time_point quiet_until_{};
    Clock::duration quiet_{};
    std::uint64_t unlogged_ = 0;  // problems
};

}  // namespace ocean::bridge
