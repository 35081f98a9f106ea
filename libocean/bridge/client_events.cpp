// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "client_events.hpp"

#include <algorithm>
#include <utility>

namespace ocean::bridge {
namespace {

using Kind = ClientEvent::Kind;

/// What an owner that does not look keeps of lines; of values it keeps them all, once.
constexpr std::size_t kMostLines = 1000;

bool is_value(const ClientEvent& event, const std::string& name) {
    return event.kind == Kind::value && event.name == name;
}

}  // namespace

std::vector<ClientEvent> ClientEvents::take() {
    value_at_.clear();
    turned_.clear();
    line_count_ = 0;
    return std::exchange(events_, {});
}

void ClientEvents::drop_values(const std::string& name) {
    if (!value_at_.contains(name)) return;
    std::erase_if(events_, [&](const ClientEvent& event) { return is_value(event, name); });
    index_values();
}

/// Of what two writers have made of a value in turn the latest of each.
void ClientEvents::keep_one_of(const std::string& name) {
    const auto of_it = [&](const ClientEvent& event) { return is_value(event, name); };
    const auto first = std::ranges::find_if(events_, of_it);
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
        const bool turned = turned_.erase(event.name) > 0;
        if (const auto found = value_at_.find(event.name); found != value_at_.end()) {
            if (!turned) {
                events_[found->second].text = std::move(event.text);
                return;
            }
            keep_one_of(event.name);
        }
        value_at_[event.name] = events_.size();
    } else {
        if (event.kind == Kind::writer) turned_.insert(event.name);
        if (++line_count_ > kMostLines) {
            const auto oldest = std::ranges::find_if(
                events_, [](const ClientEvent& old) { return old.kind != Kind::value; });
            events_.erase(oldest);
            index_values();
        }
    }
    events_.push_back(std::move(event));
}

}  // namespace ocean::bridge
