// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The events of a line client that its program has not taken yet: every line, and the latest change
// of each value. No threads and no sockets.
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "ocean/internal/bridge/line_client.hpp"

namespace ocean::bridge {

class ClientEvents {
  public:
    bool empty() const { return events_.empty(); }
    /// Removes and returns all events, in order.
    std::vector<ClientEvent> take();
    /// Adds an event. A value replaces the value before it, unless its writer has changed in
    /// between: then the latest value of each writer is kept. Beyond a limit the oldest other line
    /// is dropped.
    void add(ClientEvent event);
    /// Removes the values of a name.
    void drop_values(const std::string& name);

  private:
    void keep_one_of(const std::string& name);
    void index_values();

    std::vector<ClientEvent> events_;
    std::map<std::string, std::size_t> value_at_;  // index in events_ of a name's latest value
    std::set<std::string> rewritten_;  // names whose writer has changed since their latest value
    std::size_t line_count_ = 0;
};

}  // namespace ocean::bridge
