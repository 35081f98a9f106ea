// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Shared by the tests of the bridge: a board that a test moves, and a client that uses plain socket
// calls and no code of the library.
#pragma once

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "descriptors.hpp"
#include "ocean/internal/bridge/hub.hpp"
#include "ocean/internal/bridge/line_server.hpp"
#include "ocean/internal/bridge/source.hpp"

namespace ocean::bridge::test {

/// Far beyond every duration on a busy machine: a test that reaches this limit has failed.
inline constexpr int kPatience = 120'000;  // ms

/// A map: an analog input of the first board sets the wind.
inline const std::string kKnob =
    "[[map]]\nfrom = \"board0/a1\"\nto = \"wind_speed\"\nin = [0, 75]\nout = [0, 75]\n"
    "hysteresis = 0\n";

/// The other end of a board: the test reports, and sees the values of outputs.
struct Board {
    Source::Listener listener;
    std::vector<std::pair<std::string, double>> told;
    std::function<void()> when_told;  // called in the server's thread, which it may block
};

class TestSource : public Source {
  public:
    explicit TestSource(std::shared_ptr<Board> board) : board_(std::move(board)) {}
    std::vector<Channel> channels() const override {
        return {{"board0/a1", 0, 1e9, false}, {"board0/dac1", 0, 255, true}};
    }
    void start(Listener listener) override { board_->listener = std::move(listener); }
    void stop() override {}
    void put(const std::string& channel, double value) override {
        board_->told.emplace_back(channel, value);
        if (board_->when_told) board_->when_told();
    }

  private:
    std::shared_ptr<Board> board_;
};

/// A connection over loopback.
class RawClient {
  public:
    explicit RawClient(const Endpoint& server, int receive_buffer = 0) {
        descriptor_ = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
        if (receive_buffer > 0) {
            ::setsockopt(descriptor_, SOL_SOCKET, SO_RCVBUF, &receive_buffer,
                         sizeof receive_buffer);
        }
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_port = htons(server.port);
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        connected_ = ::connect(descriptor_, reinterpret_cast<const sockaddr*>(&address),
                               sizeof address) == 0;
    }
    RawClient(RawClient&& other) noexcept
        : descriptor_(std::exchange(other.descriptor_, -1)),
          connected_(other.connected_),
          buffer_(std::move(other.buffer_)) {}
    RawClient& operator=(RawClient&&) = delete;
    ~RawClient() { close(); }

    bool connected() const { return connected_; }
    int descriptor() const { return descriptor_; }
    void close() {
        if (descriptor_ >= 0) ::close(std::exchange(descriptor_, -1));
    }
    /// As a crash ends it: with a reset.
    void reset() {
        const linger now{1, 0};
        ::setsockopt(descriptor_, SOL_SOCKET, SO_LINGER, &now, sizeof now);
        close();
    }

    void send(std::string_view bytes) const {
        while (!bytes.empty()) {
            const auto sent = ::send(descriptor_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
            if (sent <= 0) return;
            bytes.remove_prefix(static_cast<std::size_t>(sent));
        }
    }

    /// The next line without its end; "" at the end of the connection, "(nothing)" if none comes.
    std::string line(int milliseconds = kPatience) {
        for (;;) {
            if (const std::size_t end = buffer_.find('\n'); end != std::string::npos) {
                std::string line = buffer_.substr(0, end);
                buffer_.erase(0, end + 1);
                if (line.ends_with('\r')) line.pop_back();
                return line;
            }
            pollfd waits{descriptor_, POLLIN, 0};
            if (::poll(&waits, 1, milliseconds) <= 0) return "(nothing)";
            char block[4096];
            const auto count = ::recv(descriptor_, block, sizeof block, 0);
            if (count <= 0) return "";
            buffer_.append(block, static_cast<std::size_t>(count));
        }
    }
    /// Sends a line; the first line that comes back.
    std::string ask(const std::string& request) {
        send(request + "\n");
        return line();
    }
    /// The next line that begins so.
    std::string line_with(std::string_view begin) {
        for (;;) {
            std::string next = line();
            if (next.starts_with(begin) || next.empty() || next == "(nothing)") return next;
        }
    }

  private:
    int descriptor_ = -1;
    bool connected_ = false;
    std::string buffer_;
};

/// A bridge with a test's board whose a1 is a parameter.
struct Served {
    explicit Served(ServerOptions options = {}, const std::string& map = "")
        : hub({.map_text = map}, sources(board)), server(on_any_port(std::move(options)), hub) {}

    static std::vector<std::unique_ptr<Source>> sources(const std::shared_ptr<Board>& board) {
        std::vector<std::unique_ptr<Source>> list;
        list.push_back(std::make_unique<TestSource>(board));
        return list;
    }
    static ServerOptions on_any_port(ServerOptions options) {
        if (options.listen.port == 4747) options.listen.port = 0;
        return options;
    }

    RawClient client() const {
        RawClient raw(server.endpoint());
        raw.line();  // the greeting
        return raw;
    }
    void turn(double value) const { board->listener.report({Clock::now(), "board0/a1", value}); }

    std::shared_ptr<Board> board = std::make_shared<Board>();
    Hub hub;
    LineServer server;
};

}  // namespace ocean::bridge::test
