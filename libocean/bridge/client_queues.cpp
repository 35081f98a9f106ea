// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "client_queues.hpp"

#include <algorithm>
#include <utility>

#include "ocean/error.hpp"
#include "ocean/internal/bridge/line_protocol.hpp"
#include "ocean/parameter_table.hpp"

namespace ocean::bridge {
namespace {

using Kind = ClientEvent::Kind;

/// Lines that are kept for a program that does not take them; values are not limited.
constexpr std::size_t kMaxKeptLines = 1000;

bool is_value(const ClientEvent& event, const std::string& name) {
    return event.kind == Kind::value && event.name == name;
}

using Kind = ClientEvent::Kind;

/// Lines of the program that wait to be sent; older ones are dropped.
constexpr std::size_t kMaxUnsentLines = 1000;

/// Returns false for GET, LIST and HELP, which are answered by their values, not by OK.
bool is_answered_by_ok(const std::string& line) {
    const auto parsed = parse_request(line);
    if (!parsed) return false;
    const Request* request = std::get_if<Request>(&*parsed);
    if (request == nullptr) return true;
    return request->verb != Verb::get && request->verb != Verb::list && request->verb != Verb::help;
}

}  // namespace

std::vector<ClientEvent> ClientEvents::take() {
    value_at_.clear();
    rewritten_.clear();
    line_count_ = 0;
    return std::exchange(events_, {});
}

void ClientEvents::drop_values(const std::string& name) {
    if (!value_at_.contains(name)) return;
    std::erase_if(events_, [&](const ClientEvent& event) { return is_value(event, name); });
    index_values();
}

/// Keeps the latest of a name's values, so that with the next one two writers have one each.
void ClientEvents::keep_one_of(const std::string& name) {
    const auto is_its_value = [&](const ClientEvent& event) { return is_value(event, name); };
    const auto first = std::ranges::find_if(events_, is_its_value);
    if (first == events_.begin() + static_cast<std::ptrdiff_t>(value_at_.at(name))) return;
    events_.erase(first);
    index_values();
}

void ClientEvents::index_values() {
    value_at_.clear();
    for (std::size_t i = 0; i < events_.size(); ++i) {
        if (events_[i].kind == Kind::value) value_at_[events_[i].name] = i;
    }
}

void ClientEvents::add(ClientEvent event) {
    if (event.kind == Kind::value) {
        const bool was_rewritten = rewritten_.erase(event.name) > 0;
        if (const auto found = value_at_.find(event.name); found != value_at_.end()) {
            if (!was_rewritten) {
                events_[found->second].text = std::move(event.text);
                return;
            }
            keep_one_of(event.name);
        }
        value_at_[event.name] = events_.size();
    } else {
        if (event.kind == Kind::writer) rewritten_.insert(event.name);
        if (++line_count_ > kMaxKeptLines) {
            const auto oldest = std::ranges::find_if(
                events_, [](const ClientEvent& old) { return old.kind != Kind::value; });
            events_.erase(oldest);
            index_values();
        }
    }
    events_.push_back(std::move(event));
}

std::string full_name(const std::string& name) {
    if (name.starts_with("app.")) return name;
    try {
        const ParameterRef ref = find_parameter(name);
        return ref.info->path(ref.item);
    } catch (const Error&) {
        return name;  // of a bridge that has more parameters
    }
}

bool ClientQueues::is_connected() const {
    const std::lock_guard lock(mutex_);
    return is_connected_;
}

std::vector<ClientEvent> ClientQueues::events() {
    const std::lock_guard lock(mutex_);
    return events_.take();
}

std::vector<ClientEvent> ClientQueues::wait(std::chrono::milliseconds limit) {
    std::unique_lock lock(mutex_);
    arrived_.wait_for(lock, limit, [this] { return !events_.empty(); });
    return events_.take();
}

bool ClientQueues::set(const std::string& given, const std::string& value, bool is_request) {
    if (given.empty() || (given + value).find_first_of("\r\n") != std::string::npos) return false;
    const std::string name = full_name(given);
    const std::lock_guard lock(mutex_);
    wanted_[name] = value;
    if (is_request) {
        reported_.erase(name);
        events_.drop_values(name);
    } else {
        reported_.insert(name);
    }
    return needs_wake();
}

bool ClientQueues::send(const std::string& line) {
    const std::lock_guard lock(mutex_);
    if (!is_connected_) return false;
    lines_.push_back(line);
    if (lines_.size() > kMaxUnsentLines) lines_.pop_front();
    return needs_wake();
}

bool ClientQueues::needs_wake() {
    return !std::exchange(woken_, true);
}

void ClientQueues::woken() {
    const std::lock_guard lock(mutex_);
    woken_ = false;
}

void ClientQueues::deliver(ClientEvent event) {
    const std::lock_guard lock(mutex_);
    const bool is_overtaken =
        event.kind == Kind::value && (wanted_.contains(event.name) || is_pending(event.name));
    if (is_overtaken && !reported_.contains(event.name)) return;
    events_.add(std::move(event));
    arrived_.notify_all();
}

bool ClientQueues::is_pending(const std::string& name) const {
    return std::ranges::any_of(pending_, [&](const PendingLine& line) {
        return line.kind == PendingLine::Kind::value && line.name == name;
    });
}

void ClientQueues::connected() {
    const std::lock_guard lock(mutex_);
    is_connected_ = true;
}

bool ClientQueues::disconnected() {
    const std::lock_guard lock(mutex_);
    for (const PendingLine& line : pending_) {
        if (line.kind == PendingLine::Kind::value) wanted_.try_emplace(line.name, line.value);
    }
    pending_.clear();
    lines_.clear();
    return std::exchange(is_connected_, false);
}

void ClientQueues::expect_silent_answer() {
    const std::lock_guard lock(mutex_);
    pending_.push_back({PendingLine::Kind::silent});
}

bool ClientQueues::answered() {
    const std::lock_guard lock(mutex_);
    if (pending_.empty()) return false;
    const PendingLine::Kind kind = pending_.front().kind;
    pending_.pop_front();
    return kind == PendingLine::Kind::reply;
}

std::string ClientQueues::take_lines() {
    std::string lines;
    const std::lock_guard lock(mutex_);
    if (!is_connected_) return lines;
    std::erase_if(wanted_, [&](const auto& wanted) {
        const auto& [name, value] = wanted;
        if (is_pending(name)) return false;
        lines += "SET " + name + ' ' + value + "\r\n";
        pending_.push_back({PendingLine::Kind::value, name, value});
        return true;
    });
    for (const std::string& line : std::exchange(lines_, {})) {
        lines += line + "\r\n";
        if (is_answered_by_ok(line)) pending_.push_back({PendingLine::Kind::reply});
    }
    return lines;
}

}  // namespace ocean::bridge
