// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "ocean/internal/bridge/line_client.hpp"

#include <algorithm>
#include <array>
#include <asio.hpp>
#include <thread>
#include <utility>

#include "client_queues.hpp"
#include "ocean/internal/bridge/line_protocol.hpp"
#include "ocean/internal/bridge/source.hpp"
#include "ocean/internal/checked_text.hpp"

namespace ocean::bridge {
namespace {

using asio::ip::tcp;
using Kind = ClientEvent::Kind;

constexpr auto kMinRetryInterval = std::chrono::milliseconds(100);
constexpr auto kMaxRetryInterval = std::chrono::milliseconds(3000);
constexpr auto kConnectTimeout = std::chrono::seconds(5);
/// After this silence a PING is sent; after kSilenceTimeout the connection is lost.
constexpr auto kPingInterval = std::chrono::seconds(2);
constexpr auto kSilenceTimeout = std::chrono::seconds(10);

}  // namespace

/// The connection. All members but queues_ and the two functions above `private` belong to the
/// connection's own thread.
class LineClient::Impl {
  public:
    explicit Impl(LineClientOptions options)
        : options_(std::move(options)),
          socket_(io_),
          resolver_(io_),
          retry_timer_(io_),
          ping_timer_(io_) {
        check_silence();
        connect();
        thread_ = std::thread([this] { io_.run(); });
    }

    ~Impl() {
        asio::post(io_, [this] { io_.stop(); });
        thread_.join();
    }

    ClientQueues& queues() { return queues_; }
    void wake() {
        asio::post(io_, [this] {
            queues_.woken();
            flush();
        });
    }

  private:
    void connect() {
        const std::size_t attempt = ++attempt_;
        last_byte_ = Clock::now();
        resolver_.async_resolve(
            options_.server.host, std::to_string(options_.server.port),
            [this, attempt](asio::error_code error, const tcp::resolver::results_type& found) {
                if (attempt != attempt_) return;
                if (error) return lose(error.message());
                asio::async_connect(socket_, found,
                                    [this, attempt](asio::error_code failed, const tcp::endpoint&) {
                                        if (attempt != attempt_) return;
                                        if (failed) return lose(failed.message());
                                        asio::error_code ignored;
                                        socket_.set_option(tcp::no_delay(true), ignored);
                                        splitter_ = {};
                                        read();
                                    });
            });
    }

    void lose(const std::string& reason) {
        ++attempt_;
        asio::error_code ignored;
        socket_.close(ignored);
        resolver_.cancel();
        writing_.clear();
        unsent_.clear();
        const bool was_connected = queues_.disconnected();
        if (was_connected || reason != last_loss_) queues_.deliver({Kind::lost, "", reason});
        last_loss_ = reason;
        if (was_connected) retry_interval_ = kMinRetryInterval;
        retry_timer_.expires_after(retry_interval_);
        retry_interval_ =
            std::min<std::chrono::milliseconds>(2 * retry_interval_, kMaxRetryInterval);
        retry_timer_.async_wait([this](asio::error_code stopped) {
            if (!stopped) connect();
        });
    }

    void read() {
        socket_.async_read_some(asio::buffer(block_),
                                [this, attempt = attempt_](asio::error_code error, std::size_t n) {
                                    if (attempt != attempt_) return;
                                    if (error) return lose(error.message());
                                    last_byte_ = Clock::now();
                                    std::string_view bytes(block_.data(), n);
                                    while (attempt == attempt_) {
                                        const auto line = splitter_.next(bytes);
                                        if (!line) break;
                                        if (line->fault.empty()) receive(line->text);
                                    }
                                    if (attempt == attempt_) read();
                                });
    }

    void receive(const std::string& line) {
        ServerLine parts = parse_server_line(line);
        if (!queues_.is_connected()) return greet(parts, line);
        if (parts.word == "UPD" || parts.word == "VAL") {
            queues_.deliver({Kind::value, full_name(parts.name), std::move(parts.rest)});
        } else if (parts.word == "EVT" && parts.name == "WRITER") {
            const std::size_t blank = parts.rest.find(' ');
            if (blank == std::string::npos) return;
            queues_.deliver({Kind::writer, full_name(parts.rest.substr(0, blank)),
                             parts.rest.substr(blank + 1)});
        } else if (parts.word == "EVT") {
            queues_.deliver({Kind::notice, "", line.substr(4)});
        } else if (parts.word == "OK" || parts.word == "ERR") {
            receive_answer(line);
        } else {
            queues_.deliver({Kind::reply, "", line});
        }
    }

    void greet(const ServerLine& parts, const std::string& line) {
        if (parts.word != "OBP" || parts.name != std::to_string(kProtocolVersion)) {
            return lose("not a bridge; it answers: " + text::printable(line));
        }
        queues_.connected();
        retry_interval_ = kMinRetryInterval;
        last_loss_.clear();
        asio::error_code gone;
        const tcp::endpoint own = socket_.local_endpoint(gone);
        queues_.deliver(
            {Kind::connected, Endpoint{own.address().to_string(), own.port()}.text(), line});
        if (!options_.token.empty()) send_silently("AUTH " + options_.token);
        // Values set before the connection go first, so that the snapshot has them.
        flush();
        std::string subscribe = "SUBSCRIBE";
        for (const std::string& name : options_.names) subscribe += ' ' + name;
        if (options_.subscribe) send_silently(subscribe);
        flush();
    }

    /// Each line but GET, LIST and HELP is answered in its turn by OK or ERR.
    void receive_answer(const std::string& line) {
        const bool is_visible = queues_.answered();
        flush();
        if (line.starts_with("ERR ")) {
            queues_.deliver({Kind::refused, "", line.substr(4)});
        } else if (is_visible) {
            queues_.deliver({Kind::reply, "", line});
        }
    }

    /// Queues a line of the client's own, whose answer is not delivered.
    void send_silently(const std::string& line) {
        unsent_ += line + "\r\n";
        queues_.expect_silent_answer();
    }

    void flush() {
        if (!writing_.empty()) return;
        unsent_ += queues_.take_lines();
        if (unsent_.empty() || !queues_.is_connected()) return;
        writing_.swap(unsent_);
        asio::async_write(socket_, asio::buffer(writing_),
                          [this, attempt = attempt_](asio::error_code error, std::size_t) {
                              if (attempt != attempt_) return;
                              writing_.clear();
                              if (error) return lose(error.message());
                              flush();
                          });
    }

    void check_silence() {
        ping_timer_.expires_after(kPingInterval);
        ping_timer_.async_wait([this](asio::error_code stopped) {
            if (stopped) return;
            const auto silence = Clock::now() - last_byte_;
            const bool is_connected = queues_.is_connected();
            const auto limit = is_connected ? Clock::duration(kSilenceTimeout) : kConnectTimeout;
            if (socket_.is_open() && silence > limit) {
                lose("it does not answer");
            } else if (is_connected && silence > kPingInterval) {
                send_silently("PING");
                flush();
            }
            check_silence();
        });
    }

    const LineClientOptions options_;
    ClientQueues queues_;
    asio::io_context io_{1};
    tcp::socket socket_;
    tcp::resolver resolver_;
    asio::steady_timer retry_timer_;
    asio::steady_timer ping_timer_;
    std::size_t attempt_ = 0;  // handlers of an earlier attempt do nothing
    std::chrono::milliseconds retry_interval_ = kMinRetryInterval;
    std::string last_loss_;
    Clock::time_point last_byte_{};
    std::array<char, 8192> block_{};
    LineSplitter splitter_;
    std::string unsent_;
    std::string writing_;  // "" if no write is pending
    std::thread thread_;
};

LineClient::LineClient(LineClientOptions options)
    : impl_(std::make_unique<Impl>(std::move(options))) {}

LineClient::~LineClient() = default;

bool LineClient::connected() const {
    return impl_->queues().is_connected();
}

std::vector<ClientEvent> LineClient::events() {
    return impl_->queues().events();
}

std::vector<ClientEvent> LineClient::wait(std::chrono::milliseconds limit) {
    return impl_->queues().wait(limit);
}

void LineClient::set(const std::string& name, const std::string& value) {
    if (impl_->queues().set(name, value, true)) impl_->wake();
}

void LineClient::report(const std::string& name, const std::string& value) {
    if (impl_->queues().set(name, value, false)) impl_->wake();
}

void LineClient::send(const std::string& line) {
    if (impl_->queues().send(line)) impl_->wake();
}

}  // namespace ocean::bridge
