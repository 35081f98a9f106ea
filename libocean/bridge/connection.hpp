// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// One client of the line server: what it sent, what it is still to be sent, what it subscribes to.
// Nothing of it grows without bound: what comes too fast is not read, and of values that it does
// not take in time only the latest is kept.
#pragma once

#include <array>
#include <asio.hpp>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/bridge/line_protocol.hpp"
#include "ocean/bridge/line_server.hpp"

namespace ocean::bridge {

class Connection : public std::enable_shared_from_this<Connection> {
  public:
    using Socket = asio::ip::tcp::socket;

    /// What it needs of the server.
    struct Host {
        const ServerOptions& options;
        Hub& hub;
        std::function<void(std::string)> log;
        /// Values or events may be new.
        std::function<void()> changed;
        std::function<void(Connection&)> ended;
    };

    Connection(Socket socket, const Host& host);

    const std::string& peer() const { return peer_; }
    void begin();
    /// Sends what is new of its subscriptions, unless it has not taken the last of it yet.
    void update();
    void tell(std::string_view event);
    /// What has gone on for too long.
    void look_around(Clock::time_point now);
    /// `why` is for the log.
    void end(std::string_view why);
    /// A last line, and the end when it is written.
    void leave(std::string_view line);

  private:
    void read();
    void work();
    void pause(Clock::duration how_long);
    void handle(const LineSplitter::Line& line);
    void answer(const Request& request);
    void subscribe(const std::vector<std::string>& names, bool wanted);
    void set(const std::string& name, const std::string& value);
    void authenticate(const std::string& guess);
    void list();
    void help();
    void put(std::string_view line);
    /// As they are: telnet's commands are no lines.
    void put_bytes(std::string_view bytes);
    void flush();
    void refuse(std::string_view code, const std::string& text) { put(refusal_line({code, text})); }

    Socket socket_;
    const Host& host_;
    asio::steady_timer pause_;
    std::string peer_;
    std::array<char, 2048> block_{};
    std::string_view unread_;  // of the block
    LineSplitter splitter_;
    enum class Input { reading, working, waits_for_time, waits_for_room };
    Input input_ = Input::reading;
    double tokens_;
    Clock::time_point counted_ = Clock::now();

    std::string out_;      // behind what is on its way
    std::string writing_;  // on its way; empty if nothing is
    Clock::time_point wrote_ = Clock::now();
    Clock::time_point heard_ = Clock::now();
    struct Subscription {
        std::string name;        // that it was asked by; "" = it was not
        std::uint64_t told = 0;  // revision
    };
    std::vector<Subscription> subscriptions_;  // one for each value
    std::size_t listens_to_ = 0;
    std::uint64_t looked_at_ = 0;  // revision
    bool flush_posted_ = false;
    bool open_ = true;
    bool leaving_ = false;  // when all is written
    bool trusted_ = false;
    int guesses_ = 0;
};

}  // namespace ocean::bridge
