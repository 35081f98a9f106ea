// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "ocean/bridge/line_server.hpp"

#include <algorithm>
#include <asio.hpp>
#include <atomic>
#include <deque>
#include <iterator>
#include <mutex>
#include <optional>
#include <set>
#include <thread>
#include <utility>
#include <variant>
#include <vector>

#include "address.hpp"
#include "connection.hpp"
#include "ocean/error.hpp"
#include "osc_port.hpp"

namespace ocean::bridge {
namespace {

using asio::ip::tcp;

/// Changes that come faster go out together: a board of 1000 reports a second is 500 lines a second
/// for each client. Far below the 10 ms between the reports of common boards, so that it does not
/// beat against them.
constexpr auto kLeastUpdateInterval = std::chrono::milliseconds(2);
constexpr auto kLookAround = std::chrono::milliseconds(500);
/// What clients have to take the last line in; the end waits for those alone that do not read.
constexpr auto kLastWords = std::chrono::milliseconds(500);
constexpr auto kAcceptAgain = std::chrono::milliseconds(100);
constexpr std::size_t kMostClients = 100'000;
/// A report, or an event. Their order counts.
using BoardNews = std::variant<Report, BoardEvent>;
/// Of boards, while this thread is busy.
constexpr std::size_t kMostReports = 65536;

const ServerOptions& checked(const ServerOptions& options) {
    if (!options.listen.is_loopback() && options.token.empty()) {
        const std::string what = "others than this machine may come there only with --token-file";
        throw Error(ErrorKind::invalid_value, "--listen " + options.listen.text() + ": " + what,
                    {.what = what, .parameter = "--listen", .value = options.listen.text()});
    }
    if (options.clients < 1 || options.clients > kMostClients) {
        const std::string given = std::to_string(options.clients);
        throw Error(ErrorKind::invalid_value, "--clients " + given + ": allowed: 1 .. 100000",
                    {.parameter = "--clients", .value = given, .allowed = "1 .. 100000"});
    }
    require_valid(options.osc);
    require_descriptors(options.clients);
    return options;
}

}  // namespace

class LineServer::Core {
  public:
    Core(ServerOptions options, Hub& hub)
        : options_(std::move(options)),
          hub_(hub),
          host_{checked(options_), hub_, [this](std::string line) { log(std::move(line)); },
                [this] { changed(); }, [this](Connection& gone) { ended(gone); }},
          acceptor_(io_),
          update_timer_(io_),
          advance_timer_(io_),
          second_timer_(io_),
          accept_timer_(io_),
          last_timer_(io_) {
        listen();
        open_osc();
        accept();
        look_around();
        hub_.start({[this](Report report) { take(std::move(report)); },
                    [this](BoardEvent event) { take(std::move(event)); }});
        thread_ = std::thread([this] { io_.run(); });
    }

    ~Core() { stop(); }

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
        std::string interfaces;
        for (const std::string& name : network_interfaces()) {
            interfaces += (interfaces.empty() ? "" : ", ") + name;
        }
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
                // Without descriptors left, say: that passes, and must not be a busy loop.
                accept_timer_.expires_after(kAcceptAgain);
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
                    " clients are there");
                connection->leave(refusal_line({"BUSY", "no more clients are taken"}));
            }
            accept();
        });
    }

    void ended(Connection& gone) {
        hub_.client_left(gone.peer());
        connections_.erase(gone.shared_from_this());
        count_ = connections_.size();
        if (ending_ && connections_.empty()) last_timer_.cancel();
        changed();
    }

    /// A copy: whoever is told something may end.
    std::vector<std::shared_ptr<Connection>> all() const {
        return {connections_.begin(), connections_.end()};
    }

    // From the boards' threads.
    void take(BoardNews news) {
        const std::lock_guard lock(mutex_);
        if (news_.size() < kMostReports) news_.push_back(std::move(news));
        if (std::exchange(woken_, true)) return;
        asio::post(io_, [this] { work_off(); });
    }

    /// Some of it: between them clients are heard and told, however fast a board reports.
    void work_off() {
        constexpr std::size_t kAtOnce = 64;
        std::vector<BoardNews> some;
        {
            const std::lock_guard lock(mutex_);
            const auto end =
                news_.begin() + static_cast<std::ptrdiff_t>(std::min(news_.size(), kAtOnce));
            some.assign(std::move_iterator(news_.begin()), std::move_iterator(end));
            news_.erase(news_.begin(), end);
            woken_ = !news_.empty();
            if (woken_) asio::post(io_, [this] { work_off(); });
        }
        for (BoardNews& news : some) {
            if (const auto* report = std::get_if<Report>(&news)) {
                hub_.report(*report);
            } else {
                hub_.board_event(std::get<BoardEvent>(news));
            }
        }
        changed();
    }

    void tell(const std::string& event) {
        log(event);
        for (const auto& connection : all()) connection->tell(event);
    }

    /// Something may be new: for the clients, and of when the map is to be looked at again.
    void changed() {
        if (ending_) return;
        for (const std::string& event : hub_.events()) tell(event);
        if (std::exchange(update_due_, true)) return;
        const auto now = Clock::now();
        update_timer_.expires_at(std::max(now, updated_ + kLeastUpdateInterval));
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
        if (std::exchange(told_, hub_.values().revision()) != hub_.values().revision()) {
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

    void look_around() {
        second_timer_.expires_after(kLookAround);
        second_timer_.async_wait([this](asio::error_code stopped) {
            if (stopped || ending_) return;
            hub_.look_around();
            const auto now = Clock::now();
            for (const auto& connection : all()) connection->look_around(now);
            if (osc_) osc_->look_around(now);
            changed();
            look_around();
        });
    }

    void end_all() {
        ending_ = true;
        asio::error_code ignored;
        acceptor_.close(ignored);
        for (asio::steady_timer* timer :
             {&update_timer_, &advance_timer_, &second_timer_, &accept_timer_}) {
            timer->cancel();
        }
        if (osc_) osc_->close();
        for (const auto& connection : all()) connection->leave(event_line("STOP"));
        hub_.stop();
        hub_.finish();
        for (const std::string& event : hub_.events()) log(event);
        // From now on: saving a take may need longer than that.
        last_timer_.expires_after(kLastWords);
        last_timer_.async_wait([this](asio::error_code) {
            for (const auto& connection : all()) connection->end("");
        });
        if (connections_.empty()) last_timer_.cancel();
    }

    const ServerOptions options_;
    Hub& hub_;
    const Connection::Host host_;
    asio::io_context io_{1};
    tcp::acceptor acceptor_;
    asio::steady_timer update_timer_;
    asio::steady_timer advance_timer_;
    asio::steady_timer second_timer_;
    asio::steady_timer accept_timer_;
    asio::steady_timer last_timer_;
    std::optional<OscPort> osc_;
    std::set<std::shared_ptr<Connection>> connections_;
    std::atomic<std::size_t> count_ = 0;
    Endpoint endpoint_;
    bool update_due_ = false;
    bool ending_ = false;
    Clock::time_point updated_{};
    std::uint64_t told_ = 0;

    std::mutex mutex_;  // of what boards brought
    std::deque<BoardNews> news_;
    bool woken_ = false;

    std::mutex stop_mutex_;
    std::thread thread_;
};

LineServer::LineServer(ServerOptions options, Hub& hub)
    : core_(std::make_unique<Core>(std::move(options), hub)) {}

LineServer::~LineServer() = default;

Endpoint LineServer::endpoint() const {
    return core_->endpoint();
}

std::optional<Endpoint> LineServer::osc_endpoint() const {
    return core_->osc_endpoint();
}

std::size_t LineServer::clients() const {
    return core_->clients();
}

void LineServer::stop() {
    core_->stop();
}

}  // namespace ocean::bridge
