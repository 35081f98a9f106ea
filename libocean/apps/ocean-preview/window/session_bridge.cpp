// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "window/session_bridge.hpp"

#include <utility>

namespace ocean::app {

SessionBridge::SessionBridge(BridgeRows& rows, BridgeWishes wishes)
    : rows_(rows), wishes_(std::move(wishes)) {}

void SessionBridge::join(const bridge::LineClientOptions& bridge) {
    link_.emplace(bridge, wishes_);
    rows_.link = &*link_;
}

std::string SessionBridge::serve(const Sea& sea) {
    leave();
    host_.start(rows_.host, sea);
    join({.server = host_.endpoint(), .token = rows_.host.token});
    return host_.endpoint().text();
}

void SessionBridge::leave() {
    rows_.link = nullptr;
    link_.reset();
    host_.stop();
}

void SessionBridge::tell(const std::string& name, const std::string& value) {
    if (link_) link_->tell(name, value);
}

void SessionBridge::tell_values(const LiveSea& sea) {
    if (link_) link_->tell_values(sea, true);
}

void SessionBridge::tell_clock(const LiveSea& sea, double frame_rate) {
    if (link_) link_->tell_clock(sea, frame_rate);
}

void SessionBridge::update_rows() {
    rows_.is_running = host_.is_running();
    if (link_) host_.leave_out_clock_of(link_->own_name());
    rows_.log = rows_.is_own ? host_.log() : link_->log();
}

}  // namespace ocean::app
