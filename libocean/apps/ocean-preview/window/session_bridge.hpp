// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The bridge of a window: one that it joins, or one that runs in this process and that it joins
// too.
#pragma once

#include <optional>
#include <string>

#include "bridge_host.hpp"
#include "bridge_link.hpp"
#include "live_sea.hpp"
#include "panel/panel_state.hpp"

namespace ocean::app {

class SessionBridge {
  public:
    /// rows: the panel's, which outlive this. calls: of BridgeLink.
    SessionBridge(BridgeRows& rows, BridgeCalls calls);

    void join(const bridge::LineClientOptions& bridge);
    /// Starts a bridge in this process with the panel's options, or starts it again, and joins it.
    /// Returns its address. Throws Error, and no bridge runs then.
    std::string serve(const Sea& sea);
    void leave();
    bool is_joined() const { return link_.has_value(); }

    // As BridgeLink; nothing happens while there is no connection.
    bool apply(LiveSea& sea) { return link_ && link_->apply(sea); }
    void send(const std::string& name, const std::string& value) {
        if (link_) link_->send(name, value);
    }
    void send_values(const LiveSea& sea) {
        if (link_) link_->send_values(sea, true);
    }
    void send_clock(const LiveSea& sea, double frame_rate) {
        if (link_) link_->send_clock(sea, frame_rate);
    }
    /// Brings the panel's rows up to date.
    void update_rows();

  private:
    BridgeRows& rows_;
    BridgeCalls calls_;
    BridgeHost host_;
    std::optional<BridgeLink> link_;
};

}  // namespace ocean::app
