// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "ocean/internal/bridge/line_server.hpp"

#include <algorithm>
#include <asio.hpp>
#include <atomic>
#include <mutex>
#include <set>
#include <thread>
#include <utility>

#include "address.hpp"
#include "board_queue.hpp"
#include "connection.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/text.hpp"
#include "osc_port.hpp"

namespace ocean::bridge {
namespace {

using asio::ip::tcp;

/// Changes that come faster are sent together: a board with 1000 reports per second makes 500 lines
/// per second for each client. The interval is far below the 10 ms between the reports of common
/// boards, with which it would otherwise beat.
constexpr auto kMinUpdateInterval = std::chrono::milliseconds(2);
/// The interval at which the map's file and idle clients are checked.
constexpr auto kPollInterval = std::chrono::milliseconds(500);
/// The time that clients have at the end to read the last line. The end waits for clients that do
/// not read, and for no others.
constexpr auto kShutdownGrace = std::chrono::milliseconds(500);
constexpr auto kAcceptRetryInterval = std::chrono::milliseconds(100);
constexpr std::size_t kMaxClients = 100'000;

const ServerOptions& checked(const ServerOptions& options) {
    if (!options.listen.is_loopback() && options.token.empty()) {
        const std::string what = "other machines may connect only with --token-file";
        throw Error(ErrorKind::invalid_value, "--listen " + options.listen.text() + ": " + what,
                    {.what = what, .parameter = "--listen", .value = options.listen.text()});
    }
    if (options.clients < 1 || options.clients > kMaxClients) {
        const std::string given = std::to_string(options.clients);
        throw Error(ErrorKind::invalid_value, "--clients " + given + ": allowed: 1 .. 100000",
                    {.parameter = "--clients", .value = given, .allowed = "1 .. 100000"});
    }
    require_valid(options.osc);
    require_descriptors(options.clients);
    return options;
}

}  // namespace

class LineServer::Impl {
  public:
    Impl(ServerOptions options, Hub& hub)
        : options_(std::move(options)),
          hub_(hub),
          host_{checked(options_), hub_, [this](std::string line) { log(std::move(line)); },
                [this] { changed(); }, [this](Connection& gone) { ended(gone); }},
          acceptor_(io_),
          update_timer_(io_),
          advance_timer_(io_),
          poll_timer_(io_),
          accept_timer_(io_),
          shutdown_timer_(io_) {
        listen();
        open_osc();
        accept();
        poll();
        hub_.start({[this](Report report) { enqueue(std::move(report)); },
                    [this](BoardEvent event) { enqueue(std::move(event)); }});
        thread_ = std::thread([this] { io_.run(); });
    }

    ~Impl() { stop(); }

    Endpoint endpoint() const { return endpoint_; }
    std::optional<Endpoint> osc_endpoint() const { return osc_ ? osc_->endpoint() : std::nullopt; }
    std::size_t clients() const { return count_; }

    void stop() {
        const std::lock_guard once(stop_mutex_);
        if (!thread_.joinable()) return;
        asio::post(io_, [this] { end_all(); });
        thread_.join();
        log("stopped");
    }

  private:
    void log(std::string line) const {
        if (options_.log) options_.log(std::move(line));
    }

    void listen() {
        const tcp::endpoint wanted(parse_address(options_.listen.host, "--listen"),
                                   options_.listen.port);
        try {
            acceptor_.open(wanted.protocol());
            acceptor_.set_option(tcp::acceptor::reuse_address(true));
            acceptor_.bind(wanted);
            acceptor_.listen(asio::socket_base::max_listen_connections);
        } catch (const asio::system_error& error) {
            throw Error(ErrorKind::output, "cannot listen on " + options_.listen.text() + ": " +
                                               error.code().message());
        }
        endpoint_ = {wanted.address().to_string(), acceptor_.local_endpoint().port()};
        log("listening on " + endpoint_.text());
        const std::string interfaces = joined(network_interfaces(), ", ");
        log(interfaces.empty() ? "no network interface is up" : "interfaces: " + interfaces);
    }

    void open_osc() {
        if (options_.osc == OscOptions()) return;
        osc_.emplace(io_, options_.osc, OscPort::Host{hub_, host_.log, host_.changed});
    }

    void accept() {
        acceptor_.async_accept([this](asio::error_code error, tcp::socket socket) {
            if (!acceptor_.is_open()) return;
            if (error) {
                // Such as no descriptor left, which passes. A retry at once would be a busy loop.
                accept_timer_.expires_after(kAcceptRetryInterval);
                accept_timer_.async_wait([this](asio::error_code stopped) {
                    if (!stopped) accept();
                });
                return;
            }
            auto connection = std::make_shared<Connection>(std::move(socket), host_);
            if (connections_.size() < options_.clients) {
                connections_.insert(connection);
                count_ = connections_.size();
                connection->begin();
            } else {
                log(connection->peer() + " refused: " + std::to_string(options_.clients) +
                    " clients are connected");
                connection->leave(
                    refusal_line({"BUSY", "the bridge has its max number of clients"}));
            }
            accept();
        });
    }

    void ended(Connection& gone) {
        hub_.client_left(gone.peer());
        connections_.erase(gone.shared_from_this());
        count_ = connections_.size();
        if (ending_ && connections_.empty()) shutdown_timer_.cancel();
        changed();
    }

    /// Returns a copy, because a connection that is sent a line may end.
    std::vector<std::shared_ptr<Connection>> all() const {
        return {connections_.begin(), connections_.end()};
    }

    /// Runs in the boards' threads.
    void enqueue(BoardMessage message) {
        if (board_queue_.enqueue(std::move(message))) wake();
    }
    void wake() {
        asio::post(io_, [this] { drain_queue(); });
    }

    /// Processes some messages at a time, so that clients are served in between, however fast a
    /// board reports.
    void drain_queue() {
        constexpr std::size_t kAtOnce = 64;
        const BoardQueue::Batch batch = board_queue_.take(kAtOnce);
        if (batch.has_more) wake();
        for (const BoardMessage& message : batch.messages) {
            if (const auto* report = std::get_if<Report>(&message)) {
                hub_.report(*report);
            } else {
                hub_.on_board_event(std::get<BoardEvent>(message));
            }
        }
        changed();
    }

    void send_event(const std::string& event) {
        log(event);
        for (const auto& connection : all()) connection->send_event(event);
    }

    /// Sends new events, and schedules update(). Called after everything that may change a value,
    /// an event, or the time of the next Hub::advance().
    void changed() {
        if (ending_) return;
        for (const std::string& event : hub_.events()) send_event(event);
        if (std::exchange(update_due_, true)) return;
        const auto now = Clock::now();
        update_timer_.expires_at(std::max(now, updated_ + kMinUpdateInterval));
        if (update_timer_.expiry() <= now) {
            asio::post(io_, [this] { update(); });
        } else {
            update_timer_.async_wait([this](asio::error_code stopped) {
                if (!stopped) update();
            });
        }
    }

    void update() {
        if (ending_) return;
        update_due_ = false;
        if (std::exchange(sent_revision_, hub_.values().revision()) != hub_.values().revision()) {
            updated_ = Clock::now();
            for (const auto& connection : all()) connection->update();
        }
        if (osc_) osc_->update();
        const auto next = hub_.next();
        if (!next) return;
        advance_timer_.expires_at(*next);
        advance_timer_.async_wait([this](asio::error_code stopped) {
            if (stopped) return;
            hub_.advance(Clock::now());
            changed();
        });
    }

    void poll() {
        poll_timer_.expires_after(kPollInterval);
        poll_timer_.async_wait([this](asio::error_code stopped) {
            if (stopped || ending_) return;
            hub_.poll_map_file();
            const auto now = Clock::now();
            for (const auto& connection : all()) connection->end_if_idle(now);
            if (osc_) osc_->end_subscriptions(now);
            changed();
            poll();
        });
    }

    void end_all() {
        ending_ = true;
        asio::error_code ignored;
        acceptor_.close(ignored);
        for (asio::steady_timer* timer :
             {&update_timer_, &advance_timer_, &poll_timer_, &accept_timer_}) {
            timer->cancel();
        }
        if (osc_) osc_->close();
        for (const auto& connection : all()) connection->leave(event_line("STOP"));
        hub_.stop();
        hub_.finish();
        for (const std::string& event : hub_.events()) log(event);
        // Begins after the take is saved, which may need longer than the grace itself.
        shutdown_timer_.expires_after(kShutdownGrace);
        shutdown_timer_.async_wait([this](asio::error_code) {
            for (const auto& connection : all()) connection->end("");
        });
        if (connections_.empty()) shutdown_timer_.cancel();
    }

    const ServerOptions options_;
    Hub& hub_;
    const Connection::Host host_;
    asio::io_context io_{1};
    tcp::acceptor acceptor_;
    asio::steady_timer update_timer_;
    asio::steady_timer advance_timer_;
    asio::steady_timer poll_timer_;
    asio::steady_timer accept_timer_;
    asio::steady_timer shutdown_timer_;
    std::optional<OscPort> osc_;
    std::set<std::shared_ptr<Connection>> connections_;
    std::atomic<std::size_t> count_ = 0;
    Endpoint endpoint_;
    bool update_due_ = false;
    bool ending_ = false;
    Clock::time_point updated_{};
    std::uint64_t sent_revision_ = 0;
    BoardQueue board_queue_;

    std::mutex stop_mutex_;
    std::thread thread_;
};

LineServer::LineServer(ServerOptions options, Hub& hub)
    : impl_(std::make_unique<Impl>(std::move(options), hub)) {}

LineServer::~LineServer() = default;

Endpoint LineServer::endpoint() const {
    return impl_->endpoint();
}

std::optional<Endpoint> LineServer::osc_endpoint() const {
    return impl_->osc_endpoint();
}

std::size_t LineServer::clients() const {
    return impl_->clients();
}

void LineServer::stop() {
    impl_->stop();
}

}  // namespace ocean::bridge
