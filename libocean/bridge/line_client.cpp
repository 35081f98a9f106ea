// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "ocean/bridge/line_client.hpp"

#include <algorithm>
#include <array>
#include <asio.hpp>
#include <condition_variable>
#include <deque>
#include <map>
#include <mutex>
#include <set>
#include <thread>
#include <utility>

#include "client_events.hpp"
#include "ocean/bridge/line_protocol.hpp"
#include "ocean/bridge/source.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/parameter_table.hpp"

namespace ocean::bridge {
namespace {

using asio::ip::tcp;
using Kind = ClientEvent::Kind;

constexpr auto kFirstRetry = std::chrono::milliseconds(100);
constexpr auto kLastRetry = std::chrono::milliseconds(3000);
constexpr auto kConnectLimit = std::chrono::seconds(5);
constexpr auto kLook = std::chrono::seconds(2);      // a PING when nothing came for so long
constexpr auto kSilence = std::chrono::seconds(10);  // then the line is dead
/// Lines of an owner that wait to be sent.
constexpr std::size_t kMostLines = 1000;

/// Owner and bridge may spell a parameter in two ways.
std::string full_name(const std::string& name) {
    if (name.starts_with("app.")) return name;
    try {
        const ParameterRef ref = find_parameter(name);
        return ref.info->path(ref.item);
    } catch (const Error&) {
        return name;  // of a bridge that knows more
    }
}

}  // namespace

class LineClient::Core {
  public:
    explicit Core(LineClientOptions options)
        : options_(std::move(options)), socket_(io_), resolver_(io_), retry_(io_), look_(io_) {
        look();
        connect();
        thread_ = std::thread([this] { io_.run(); });
    }

    ~Core() {
        asio::post(io_, [this] { io_.stop(); });
        thread_.join();
    }

    bool connected() const {
        const std::lock_guard lock(mutex_);
        return greeted_;
    }

    std::vector<ClientEvent> events() {
        const std::lock_guard lock(mutex_);
        return events_.take();
    }

    std::vector<ClientEvent> wait(std::chrono::milliseconds longest) {
        std::unique_lock lock(mutex_);
        arrived_.wait_for(lock, longest, [this] { return !events_.empty(); });
        return events_.take();
    }

    void set(const std::string& given, const std::string& value, bool as_wish) {
        if (given.empty() || (given + value).find_first_of("\r\n") != std::string::npos) return;
        const std::string name = full_name(given);
        const std::lock_guard lock(mutex_);
        wanted_[name] = value;
        if (as_wish) {
            reported_.erase(name);
            events_.drop_values(name);
        } else {
            reported_.insert(name);
        }
        wake();
    }

    void send(const std::string& line) {
        const std::lock_guard lock(mutex_);
        if (!greeted_) return;
        lines_.push_back(line);
        if (lines_.size() > kMostLines) lines_.pop_front();
        wake();
    }

  private:
    // ---- what its owner sees; all of it under the lock

    void deliver(ClientEvent event) {
        const std::lock_guard lock(mutex_);
        const bool overtaken =
            event.kind == Kind::value && (wanted_.contains(event.name) || on_its_way(event.name));
        if (overtaken && !reported_.contains(event.name)) return;
        events_.add(std::move(event));
        arrived_.notify_all();
    }
    bool on_its_way(const std::string& name) const {
        return std::ranges::find(asked_, name, &Asked::what) != asked_.end();
    }
    void wake() {
        if (std::exchange(woken_, true)) return;
        asio::post(io_, [this] {
            {
                const std::lock_guard lock(mutex_);
                woken_ = false;
            }
            flush();
        });
    }

    // ---- the connection; the thread alone

    void connect() {
        const std::size_t attempt = ++attempt_;
        heard_ = Clock::now();
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

    void lose(const std::string& why) {
        ++attempt_;
        asio::error_code ignored;
        socket_.close(ignored);
        resolver_.cancel();
        writing_.clear();
        pending_.clear();
        bool had_it = false;
        {
            const std::lock_guard lock(mutex_);
            had_it = std::exchange(greeted_, false);
            // What nobody has confirmed is said again, but for what was set since.
            for (const Asked& asked : asked_) {
                if (!asked.value.empty()) wanted_.try_emplace(asked.what, asked.value);
            }
            asked_.clear();
            lines_.clear();
        }
        if (had_it || why != last_loss_) deliver({Kind::lost, "", why});
        last_loss_ = why;
        if (had_it) delay_ = kFirstRetry;
        retry_.expires_after(delay_);
        delay_ = std::min<std::chrono::milliseconds>(2 * delay_, kLastRetry);
        retry_.async_wait([this](asio::error_code stopped) {
            if (!stopped) connect();
        });
    }

    void read() {
        socket_.async_read_some(asio::buffer(block_),
                                [this, attempt = attempt_](asio::error_code error, std::size_t n) {
                                    if (attempt != attempt_) return;
                                    if (error) return lose(error.message());
                                    heard_ = Clock::now();
                                    std::string_view bytes(block_.data(), n);
                                    while (attempt == attempt_) {
                                        const auto line = splitter_.next(bytes);
                                        if (!line) break;
                                        if (line->fault.empty()) hear(line->text);
                                    }
                                    if (attempt == attempt_) read();
                                });
    }

    void hear(const std::string& line) {
        ServerLine parts = parse_server_line(line);
        if (!greeted_) return greet(parts, line);
        if (parts.word == "UPD" || parts.word == "VAL") {
            deliver({Kind::value, full_name(parts.name), std::move(parts.rest)});
        } else if (parts.word == "EVT" && parts.name == "WRITER") {
            const std::size_t blank = parts.rest.find(' ');
            if (blank == std::string::npos) return;
            deliver({Kind::writer, full_name(parts.rest.substr(0, blank)),
                     parts.rest.substr(blank + 1)});
        } else if (parts.word == "EVT") {
            deliver({Kind::notice, "", line.substr(4)});
        } else if (parts.word == "OK" || parts.word == "ERR") {
            answered(line);
        } else {
            deliver({Kind::reply, "", line});
        }
    }

    void greet(const ServerLine& parts, const std::string& line) {
        if (parts.word != "OBP" || parts.name != std::to_string(kProtocolVersion)) {
            return lose("it says: " + text::printable(line));
        }
        {
            const std::lock_guard lock(mutex_);
            greeted_ = true;
        }
        delay_ = kFirstRetry;
        last_loss_.clear();
        asio::error_code gone;
        const tcp::endpoint own = socket_.local_endpoint(gone);
        deliver({Kind::connected, Endpoint{own.address().to_string(), own.port()}.text(), line});
        if (!options_.token.empty()) ask("AUTH " + options_.token, kSilent);
        // What was set while nobody listened goes first: the snapshot has it.
        flush();
        std::string line_out = "SUBSCRIBE";
        for (const std::string& name : options_.names) line_out += ' ' + name;
        if (options_.subscribe) ask(line_out, kSilent);
        flush();
    }

    /// Each line that asks for one is answered in its turn by OK or ERR, or by a block of lines.
    void answered(const std::string& line) {
        std::string what;
        {
            const std::lock_guard lock(mutex_);
            if (!asked_.empty()) {
                what = std::move(asked_.front().what);
                asked_.pop_front();
            }
        }
        flush();
        if (line.starts_with("ERR ")) {
            deliver({Kind::refused, "", line.substr(4)});
        } else if (what == kSpoken) {
            deliver({Kind::reply, "", line});
        }
    }

    void ask(const std::string& line, const std::string& what) {
        pending_ += line + "\r\n";
        const std::lock_guard lock(mutex_);
        asked_.push_back({what, ""});
    }

    void flush() {
        if (!writing_.empty()) return;
        {
            const std::lock_guard lock(mutex_);
            if (!greeted_) return;
        }
        {
            const std::lock_guard lock(mutex_);
            // One of a name at a time: a bridge that has more to do gets the latest, not them all.
            std::erase_if(wanted_, [this](const auto& wanted) {
                const auto& [name, value] = wanted;
                if (on_its_way(name)) return false;
                pending_ += "SET " + name + ' ' + value + "\r\n";
                asked_.push_back({name, value});
                return true;
            });
            for (const std::string& line : std::exchange(lines_, {})) {
                pending_ += line + "\r\n";
                if (expects_answer(line)) asked_.push_back({kSpoken, ""});
            }
        }
        if (pending_.empty()) return;
        writing_.swap(pending_);
        asio::async_write(socket_, asio::buffer(writing_),
                          [this, attempt = attempt_](asio::error_code error, std::size_t) {
                              if (attempt != attempt_) return;
                              writing_.clear();
                              if (error) return lose(error.message());
                              flush();
                          });
    }

    /// GET, LIST and HELP are answered by what they ask for.
    static bool expects_answer(const std::string& line) {
        const auto parsed = parse_request(line);
        if (!parsed) return false;
        const Request* request = std::get_if<Request>(&*parsed);
        if (request == nullptr) return true;
        return request->verb != Verb::get && request->verb != Verb::list &&
               request->verb != Verb::help;
    }

    void look() {
        look_.expires_after(kLook);
        look_.async_wait([this](asio::error_code stopped) {
            if (stopped) return;
            const auto silent = Clock::now() - heard_;
            bool greeted = false;
            {
                const std::lock_guard lock(mutex_);
                greeted = greeted_;
            }
            if (socket_.is_open() &&
                silent > (greeted ? Clock::duration(kSilence) : kConnectLimit)) {
                lose("it does not answer");
            } else if (greeted && silent > kLook) {
                ask("PING", kSilent);
                flush();
            }
            look();
        });
    }

    // What asked_ holds beside names of values: no name has a blank.
    inline static const std::string kSilent = " ";
    inline static const std::string kSpoken = "  ";

    const LineClientOptions options_;
    asio::io_context io_{1};
    tcp::socket socket_;
    tcp::resolver resolver_;
    asio::steady_timer retry_;
    asio::steady_timer look_;
    std::size_t attempt_ = 0;  // what an earlier one still brings is nothing
    std::chrono::milliseconds delay_ = kFirstRetry;
    std::string last_loss_;
    Clock::time_point heard_{};
    std::array<char, 8192> block_{};
    LineSplitter splitter_;
    std::string pending_;
    std::string writing_;

    mutable std::mutex mutex_;
    std::condition_variable arrived_;
    bool greeted_ = false;
    bool woken_ = false;
    ClientEvents events_;
    std::set<std::string> reported_;             // names that were reported last, not set
    std::map<std::string, std::string> wanted_;  // to be sent
    std::deque<std::string> lines_;
    struct Asked {
        std::string what;
        std::string value;  // of a name
    };
    std::deque<Asked> asked_;  // without an answer yet

    std::thread thread_;
};

LineClient::LineClient(LineClientOptions options)
    : core_(std::make_unique<Core>(std::move(options))) {}

LineClient::~LineClient() = default;

bool LineClient::connected() const {
    return core_->connected();
}

std::vector<ClientEvent> LineClient::events() {
    return core_->events();
}

std::vector<ClientEvent> LineClient::wait(std::chrono::milliseconds longest) {
    return core_->wait(longest);
}

void LineClient::set(const std::string& name, const std::string& value) {
    core_->set(name, value, true);
}

void LineClient::report(const std::string& name, const std::string& value) {
    core_->set(name, value, false);
}

void LineClient::send(const std::string& line) {
    core_->send(line);
}

}  // namespace ocean::bridge
