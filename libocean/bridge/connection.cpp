// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "connection.hpp"

#include <algorithm>
#include <utility>

#include "ocean/error.hpp"
#include "ocean/internal/checked_text.hpp"

namespace ocean::bridge {
namespace {

/// Replies that wait; with more of them no further command is read.
constexpr std::size_t kMostReplies = std::size_t{16} << 10;
/// Pushed events that wait; with more of them the client is given up.
constexpr std::size_t kMostWaiting = std::size_t{256} << 10;
/// In the system's hands, where a value can grow old.
constexpr int kSendBuffer = 32 << 10;
constexpr int kMostGuesses = 3;
constexpr auto kAfterWrongGuess = std::chrono::seconds(1);

std::string_view code_of(ErrorKind kind) {
    switch (kind) {
        case ErrorKind::not_found:
            return "UNKNOWN-NAME";
        case ErrorKind::unsupported:
            return "READONLY";
        default:
            return "RANGE";
    }
}

std::string text_of(const asio::ip::tcp::socket& socket) {
    asio::error_code gone;
    const auto remote = socket.remote_endpoint(gone);
    if (gone) return "somebody";
    return Endpoint{remote.address().to_string(), remote.port()}.text();
}

}  // namespace

Connection::Connection(Socket socket, const Host& host)
    : socket_(std::move(socket)),
      host_(host),
      pause_(socket_.get_executor()),
      peer_(text_of(socket_)),
      tokens_(host.options.commands_per_second),
      subscriptions_(host.hub.values().entries().size()),
      trusted_(host.options.token.empty()) {
    asio::error_code ignored;
    socket_.set_option(asio::ip::tcp::no_delay(true), ignored);
    socket_.set_option(asio::socket_base::keep_alive(true), ignored);
    // Telnet's Synch sends its Data Mark as urgent: out of band it would be missing behind its IAC.
    socket_.set_option(asio::socket_base::out_of_band_inline(true), ignored);
    socket_.set_option(asio::socket_base::send_buffer_size(kSendBuffer), ignored);
}

void Connection::begin() {
    host_.log(peer_ + " connected");
    put(greeting_line());
    read();
}

void Connection::end(std::string_view why) {
    if (!std::exchange(open_, false)) return;
    asio::error_code ignored;
    socket_.close(ignored);
    pause_.cancel();
    host_.log(peer_ + " ended" + (why.empty() ? "" : ": " + std::string(why)));
    host_.ended(*this);
}

void Connection::leave(std::string_view line) {
    if (!open_ || leaving_) return;
    put(line);
    leaving_ = true;
    flush();
}

void Connection::read() {
    input_ = Input::reading;
    socket_.async_read_some(asio::buffer(block_), [this, self = shared_from_this()](
                                                      asio::error_code error, std::size_t count) {
        if (!open_) return;
        if (error == asio::error::eof) {
            // Nothing more is asked, as at the end of a pipe; what was, is answered.
            leaving_ = true;
            return flush();
        }
        if (error) return end("");
        unread_ = std::string_view(block_.data(), count);
        work();
    });
}

/// Works off what was read, as far as the client keeps to the limits; reads on when all is done.
void Connection::work() {
    input_ = Input::working;
    while (open_ && !leaving_ && input_ == Input::working) {
        const Clock::time_point now = Clock::now();
        const double rate = host_.options.commands_per_second;
        tokens_ =
            std::min(rate, tokens_ + rate * std::chrono::duration<double>(now - counted_).count());
        counted_ = now;
        if (tokens_ < 1.0) return pause(std::chrono::milliseconds(100));
        if (out_.size() > kMostReplies) {
            input_ = Input::waits_for_room;
            return;
        }
        std::string replies;
        const auto line = splitter_.next(unread_, &replies);
        if (!replies.empty()) put_bytes(replies);
        if (!open_) return;
        if (!line) return read();
        tokens_ -= 1.0;
        handle(*line);
    }
}

void Connection::pause(Clock::duration how_long) {
    input_ = Input::waits_for_time;
    pause_.expires_after(how_long);
    pause_.async_wait([this, self = shared_from_this()](asio::error_code error) {
        if (!error && open_) work();
    });
}

void Connection::handle(const LineSplitter::Line& line) {
    heard_ = Clock::now();
    if (!line.fault.empty()) {
        host_.log(peer_ + ": " + std::string(line.fault));
        return refuse(line.fault, line.fault == "TOO-LONG" ? "a line has at most 1024 bytes"
                                                           : "lines are UTF-8 text");
    }
    const auto parsed = parse_request(line.text);
    const Request* request = parsed ? std::get_if<Request>(&*parsed) : nullptr;
    const bool secret = request != nullptr && request->verb == Verb::auth;
    host_.log(peer_ + ": " + (secret ? "AUTH ..." : text::printable(line.text, kLongestLine)));
    if (!parsed) return;
    if (request == nullptr) return put(refusal_line(std::get<Refusal>(*parsed)));
    try {
        answer(*request);
    } catch (const Error& error) {
        refuse(code_of(error.kind()), error.what());
    }
    host_.changed();
}

void Connection::answer(const Request& request) {
    const std::vector<std::string>& arguments = request.arguments;
    Hub& hub = host_.hub;
    const bool open_to_all = request.verb == Verb::help || request.verb == Verb::ping ||
                             request.verb == Verb::auth || request.verb == Verb::quit;
    if (!trusted_ && !open_to_all) return refuse("AUTH", "AUTH TOKEN comes first");
    const auto number = [&](const std::string& word) {
        const auto value = text::parse_number(word);
        if (value && *value > -1e9 && *value < 1e9) return *value;
        throw Error(ErrorKind::invalid_value, "'" + text::printable(word) + "' is no number");
    };
    switch (request.verb) {
        case Verb::help:
            return help();
        case Verb::list:
            return list();
        case Verb::get:
            return put(
                value_line(arguments[0], hub.values()[hub.values().find(arguments[0])].text));
        case Verb::set:
            set(arguments[0], arguments[1]);
            break;
        case Verb::subscribe:
        case Verb::unsubscribe:
            return subscribe(arguments, request.verb == Verb::subscribe);
        case Verb::out:
            hub.out(arguments[0], number(arguments[1]));
            break;
        case Verb::record: {
            const std::string file = arguments.size() > 1 ? arguments[1] : "";
            const std::string& what = arguments[0];
            if (what == "START" || what == "start") {
                hub.start_recording(file, peer_);
            } else if (what == "STOP" || what == "stop") {
                hub.stop_recording(file, peer_);
            } else {
                return refuse("USAGE", "RECORD START|STOP [FILE]");
            }
            break;
        }
        case Verb::ping:
            break;
        case Verb::auth:
            return authenticate(arguments[0]);
        case Verb::quit:
            leaving_ = true;
            break;
    }
    put("OK");
}

/// Who shows the sea says with app.* how it stands. What it says before it was told of another's
/// wish is older than the wish, and must not take its place.
void Connection::set(const std::string& name, const std::string& value) {
    Hub& hub = host_.hub;
    const std::size_t entry = hub.values().find(name);
    const ValueEntry& now = hub.values()[entry];
    const Subscription& subscription = subscriptions_[entry];
    const bool knows = subscription.name.empty() || now.writer == peer_ ||
                       std::max(now.taken, now.changed) <= subscription.told;
    if (knows || !hub.is_told_by(entry, peer_)) hub.set(name, value, peer_);
}

void Connection::authenticate(const std::string& guess) {
    if (host_.options.token.empty() || same_token(guess, host_.options.token)) {
        trusted_ = true;
        return put("OK");
    }
    if (++guesses_ == kMostGuesses) leaving_ = true;
    refuse("AUTH", "this is not the token");
    if (!leaving_) pause(kAfterWrongGuess);
}

void Connection::subscribe(const std::vector<std::string>& names, bool wanted) {
    const ValueTable& values = host_.hub.values();
    std::vector<std::pair<std::size_t, std::string>> asked;
    for (const std::string& name : names) asked.emplace_back(values.find(name), name);
    if (names.empty()) {
        for (std::size_t i = 0; i < subscriptions_.size(); ++i)
            asked.emplace_back(i, values[i].name);
    }
    put("OK");
    for (const auto& [entry, name] : asked) {
        Subscription& subscription = subscriptions_[entry];
        listens_to_ -= subscription.name.empty() ? 0 : 1;
        subscription = {wanted ? name : "", values.revision()};
        if (!wanted) continue;
        ++listens_to_;
        if (!values[entry].writer.empty()) {
            put(event_line("WRITER " + name + ' ' + values[entry].writer));
        }
        put(value_line(name, values[entry].text));
    }
}

void Connection::list() {
    put("BEGIN LIST");
    for (const ValueEntry& entry : host_.hub.values().entries()) {
        put(value_line(entry.name, entry.text));
    }
    put("END LIST");
}

void Connection::help() {
    put("BEGIN HELP");
    for (const CommandForm& form : command_forms()) {
        std::string line(form.word);
        if (!form.arguments.empty()) line += ' ' + std::string(form.arguments);
        put(line + ": " + std::string(form.help));
    }
    put("END HELP");
}

void Connection::update() {
    if (!open_ || !writing_.empty()) return;  // flush() comes back
    const ValueTable& values = host_.hub.values();
    if (std::exchange(looked_at_, values.revision()) == values.revision()) return;
    for (std::size_t i = 0; i < subscriptions_.size(); ++i) {
        Subscription& subscription = subscriptions_[i];
        if (subscription.name.empty()) continue;
        const ValueEntry& entry = values[i];
        const std::uint64_t told = std::exchange(subscription.told, values.revision());
        if (entry.taken > told && !entry.writer.empty()) {
            put(event_line("WRITER " + subscription.name + ' ' + entry.writer));
        }
        if (entry.changed > told) put(update_line(subscription.name, entry.text));
    }
    flush();
}

void Connection::tell(std::string_view event) {
    if (!open_ || listens_to_ == 0) return;
    put(event_line(event));
    flush();
}

void Connection::put(std::string_view line) {
    put_bytes(std::string(line) + "\r\n");
}

void Connection::put_bytes(std::string_view bytes) {
    out_ += bytes;
    if (out_.size() > kMostWaiting) return end("it takes nothing of what it is sent");
    if (!writing_.empty() || std::exchange(flush_posted_, true)) return;
    // After what is being done now: lines that come together leave together.
    asio::post(socket_.get_executor(), [this, self = shared_from_this()] {
        flush_posted_ = false;
        flush();
    });
}

void Connection::flush() {
    if (!open_ || !writing_.empty()) return;
    if (out_.empty()) {
        if (leaving_) end("");
        return;
    }
    writing_.swap(out_);
    wrote_ = Clock::now();
    asio::async_write(
        socket_, asio::buffer(writing_),
        // Also after each part, which shows that somebody reads.
        [this](asio::error_code error, std::size_t) -> std::size_t {
            wrote_ = Clock::now();
            return error ? 0 : writing_.size();
        },
        [this, self = shared_from_this()](asio::error_code error, std::size_t) {
            writing_.clear();
            if (!open_) return;
            if (error) return end("");
            flush();
            update();
            if (input_ == Input::waits_for_room && out_.size() <= kMostReplies) work();
        });
}

void Connection::look_around(Clock::time_point now) {
    if (!writing_.empty() && now - wrote_ > host_.options.stalled) {
        return end("it reads nothing");
    }
    if (listens_to_ == 0 && now - heard_ > host_.options.idle) {
        leave(refusal_line({"IDLE", "nothing was said for too long"}));
    }
}

}  // namespace ocean::bridge
