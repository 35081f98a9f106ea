// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "connection.hpp"

#include <algorithm>
#include <utility>

#include "ocean/error.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/nearest_name.hpp"

namespace ocean::bridge {
namespace {

/// Bytes of answers that wait to be written; beyond it no further command is read.
constexpr std::size_t kMaxAnswerBytes = std::size_t{16} << 10;
/// Bytes of answers and events that wait to be written; beyond it the connection ends.
constexpr std::size_t kMaxOutputBytes = std::size_t{256} << 10;
/// Bytes in the system's buffer, which cannot be replaced by newer values.
constexpr int kSendBufferBytes = 32 << 10;
constexpr int kMaxGuesses = 3;
constexpr auto kPauseAfterWrongGuess = std::chrono::seconds(1);

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
    if (gone) return "an unknown client";
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
    // Telnet's Synch sends its Data Mark as urgent data: out of band it would be missing after IAC.
    socket_.set_option(asio::socket_base::out_of_band_inline(true), ignored);
    socket_.set_option(asio::socket_base::send_buffer_size(kSendBufferBytes), ignored);
}

void Connection::begin() {
    host_.log(peer_ + " connected");
    put(greeting_line());
    read();
}

void Connection::end(std::string_view reason) {
    if (!std::exchange(open_, false)) return;
    asio::error_code ignored;
    socket_.close(ignored);
    pause_.cancel();
    host_.log(peer_ + " ended" + (reason.empty() ? "" : ": " + std::string(reason)));
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
            // The client sends no more, as at the end of a pipe; its commands are still answered.
            leaving_ = true;
            return flush();
        }
        if (error) return end("");
        unread_ = std::string_view(block_.data(), count);
        work();
    });
}

/// Handles the lines that were read, as far as the client's limits allow; then reads on.
void Connection::work() {
    input_ = Input::working;
    while (open_ && !leaving_ && input_ == Input::working) {
        const Clock::time_point now = Clock::now();
        const double rate = host_.options.commands_per_second;
        tokens_ =
            std::min(rate, tokens_ + rate * std::chrono::duration<double>(now - counted_).count());
        counted_ = now;
        if (tokens_ < 1.0) return pause(std::chrono::milliseconds(100));
        if (out_.size() > kMaxAnswerBytes) {
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

void Connection::pause(Clock::duration time) {
    input_ = Input::waits_for_time;
    pause_.expires_after(time);
    pause_.async_wait([this, self = shared_from_this()](asio::error_code error) {
        if (!error && open_) work();
    });
}

void Connection::handle(const LineSplitter::Line& line) {
    heard_ = Clock::now();
    if (!line.fault.empty()) {
        host_.log(peer_ + ": " + std::string(line.fault));
        return refuse(line.fault, line.fault == "TOO-LONG" ? "a line has at most 1024 bytes"
                                                           : "a line must be UTF-8 text");
    }
    const auto parsed = parse_request(line.text);
    const Request* request = parsed ? std::get_if<Request>(&*parsed) : nullptr;
    const bool secret = request != nullptr && request->verb == Verb::auth;
    const bool is_report = request != nullptr && request->verb == Verb::set &&
                           host_.hub.is_report(request->arguments[0], request->arguments[1], peer_);
    if (!is_report || host_.options.log_reports) {
        host_.log(peer_ + ": " + (secret ? "AUTH ..." : text::printable(line.text, kMaxLineBytes)));
    }
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
    const bool needs_no_token = request.verb == Verb::help || request.verb == Verb::ping ||
                                request.verb == Verb::auth || request.verb == Verb::quit;
    if (!trusted_ && !needs_no_token) return refuse("AUTH", "send AUTH TOKEN first");
    const auto number = [&](const std::string& word) {
        const auto value = text::parse_number(word);
        if (value && *value > -1e9 && *value < 1e9) return *value;
        throw Error(ErrorKind::invalid_value, "'" + text::printable(word) + "' is not a number");
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
                constexpr std::array<std::string_view, 2> kWords = {"START", "STOP"};
                return refuse("USAGE", "RECORD START|STOP [FILE]" + did_you_mean(what, kWords));
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

/// The program that shows the sea reports the state of app.*. A report that it sends before it has
/// received the value that another client requested is older than the request, and is dropped.
void Connection::set(const std::string& name, const std::string& value) {
    Hub& hub = host_.hub;
    const std::size_t entry = hub.values().find(name);
    const ValueEntry& now = hub.values()[entry];
    const Subscription& subscription = subscriptions_[entry];
    const bool knows = subscription.name.empty() || now.writer == peer_ ||
                       std::max(now.taken, now.changed) <= subscription.sent;
    if (knows || !hub.is_owned_by(entry, peer_)) hub.set(name, value, peer_);
}

void Connection::authenticate(const std::string& guess) {
    if (host_.options.token.empty() || same_token(guess, host_.options.token)) {
        trusted_ = true;
        return put("OK");
    }
    if (++guesses_ == kMaxGuesses) leaving_ = true;
    refuse("AUTH", "wrong token");
    if (!leaving_) pause(kPauseAfterWrongGuess);
}

void Connection::subscribe(const std::vector<std::string>& names, bool wanted) {
    const ValueTable& values = host_.hub.values();
    std::vector<std::pair<std::size_t, std::string>> requested;
    for (const std::string& name : names) requested.emplace_back(values.find(name), name);
    if (names.empty()) {
        for (std::size_t i = 0; i < subscriptions_.size(); ++i) {
            requested.emplace_back(i, values[i].name);
        }
    }
    put("OK");
    for (const auto& [entry, name] : requested) {
        Subscription& subscription = subscriptions_[entry];
        subscription_count_ -= subscription.name.empty() ? 0 : 1;
        subscription = {wanted ? name : "", values.revision()};
        if (!wanted) continue;
        ++subscription_count_;
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
    if (!open_ || !writing_.empty()) return;  // flush() calls update() again
    const ValueTable& values = host_.hub.values();
    if (std::exchange(updated_, values.revision()) == values.revision()) return;
    for (std::size_t i = 0; i < subscriptions_.size(); ++i) {
        Subscription& subscription = subscriptions_[i];
        if (subscription.name.empty()) continue;
        const ValueEntry& entry = values[i];
        const std::uint64_t sent = std::exchange(subscription.sent, values.revision());
        if (entry.taken > sent && !entry.writer.empty()) {
            put(event_line("WRITER " + subscription.name + ' ' + entry.writer));
        }
        if (entry.changed > sent) put(update_line(subscription.name, entry.text));
    }
    flush();
}

void Connection::send_event(std::string_view event) {
    if (!open_ || subscription_count_ == 0) return;
    put(event_line(event));
    flush();
}

void Connection::put(std::string_view line) {
    put_bytes(std::string(line) + "\r\n");
}

void Connection::put_bytes(std::string_view bytes) {
    out_ += bytes;
    if (out_.size() > kMaxOutputBytes) return end("it does not read its answers");
    if (!writing_.empty() || std::exchange(flush_posted_, true)) return;
    // Runs after the current handler, so that its lines are written together.
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
        // Called after each part, too: then the client reads.
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
            if (input_ == Input::waits_for_room && out_.size() <= kMaxAnswerBytes) work();
        });
}

void Connection::end_if_idle(Clock::time_point now) {
    if (!writing_.empty() && now - wrote_ > host_.options.stalled) {
        return end("it reads nothing");
    }
    if (subscription_count_ == 0 && now - heard_ > host_.options.idle) {
        leave(refusal_line({"IDLE", "no command for too long"}));
    }
}

}  // namespace ocean::bridge
