// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "window/session_bridge.hpp"

#include <utility>

namespace ocean::app {

SessionBridge::SessionBridge(BridgeRows& rows, BridgeCalls calls)
    : rows_(rows), calls_(std::move(calls)) {}

void SessionBridge::join(const bridge::LineClientOptions& bridge) {
    link_.emplace(bridge, calls_);
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

void SessionBridge::update_rows() {
    rows_.is_running = host_.is_running();
    rows_.log = rows_.is_own ? host_.log() : link_->log();
}

}  // namespace ocean::app
