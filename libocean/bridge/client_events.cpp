// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "client_events.hpp"

#include <algorithm>
#include <utility>

namespace ocean::bridge {
namespace {

using Kind = ClientEvent::Kind;

/// Lines that are kept for a program that does not take them; values are not limited.
constexpr std::size_t kMaxKeptLines = 1000;

bool is_value(const ClientEvent& event, const std::string& name) {
    return event.kind == Kind::value && event.name == name;
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

}  // namespace ocean::bridge
