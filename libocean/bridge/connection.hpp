// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// One client of the line server: its input, its output and its subscriptions. None of them grows
// without bound: commands that come too fast stay unread, and of values that the client does not
// read in time only the latest is kept.
#pragma once

#include <array>
#include <asio.hpp>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/internal/bridge/line_protocol.hpp"
#include "ocean/internal/bridge/line_server.hpp"

namespace ocean::bridge {

class Connection : public std::enable_shared_from_this<Connection> {
  public:
    using Socket = asio::ip::tcp::socket;

    /// The server's part of a connection.
    struct Host {
        const ServerOptions& options;
        Hub& hub;
        std::function<void(std::string)> log;
        /// To be called after everything that may have changed a value or made an event.
        std::function<void()> changed;
        std::function<void(Connection&)> ended;
    };

    Connection(Socket socket, const Host& host);

    const std::string& peer() const { return peer_; }
    void begin();
    /// Sends the changes of subscribed values, unless earlier bytes are still being written.
    void update();
    /// Sends an event to a client with a subscription.
    void send_event(std::string_view event);
    /// Ends the connection of a client that reads nothing or asks for nothing for too long.
    void end_if_idle(Clock::time_point now);
    /// Closes the connection now. `reason` is for the log.
    void end(std::string_view reason);
    /// Sends a last line and ends the connection when it is written.
    void leave(std::string_view line);

  private:
    void read();
    void work();
    void pause(Clock::duration time);
    void handle(const LineSplitter::Line& line);
    void answer(const Request& request);
    void subscribe(const std::vector<std::string>& names, bool wanted);
    void set(const std::string& name, const std::string& value);
    void authenticate(const std::string& guess);
    void list();
    void help();
    void put(std::string_view line);
    /// Sends bytes without a line's end, such as telnet's commands.
    void put_bytes(std::string_view bytes);
    void flush();
    void refuse(std::string_view code, const std::string& text) { put(refusal_line({code, text})); }

    Socket socket_;
    const Host& host_;
    asio::steady_timer pause_;
    std::string peer_;
    std::array<char, 2048> block_{};
    std::string_view unread_;  // rest of the block
    LineSplitter splitter_;
    enum class Input { reading, working, waits_for_time, waits_for_room };
    Input input_ = Input::reading;
    double tokens_;
    Clock::time_point counted_ = Clock::now();

    std::string out_;      // bytes to write after writing_
    std::string writing_;  // bytes being written; "" if no write is pending
    Clock::time_point wrote_ = Clock::now();
    Clock::time_point heard_ = Clock::now();
    struct Subscription {
        std::string name;        // as the client requested it; "" without a subscription
        std::uint64_t sent = 0;  // revision of the last value sent
    };
    std::vector<Subscription> subscriptions_;  // one for each value
    std::size_t subscription_count_ = 0;
    std::uint64_t updated_ = 0;  // revision of the last update()
    bool flush_posted_ = false;
    bool open_ = true;
    bool leaving_ = false;  // ends when all is written
    bool trusted_ = false;
    int guesses_ = 0;
};

}  // namespace ocean::bridge
