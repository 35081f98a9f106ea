// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// What a bridge has said and the owner of the client has not taken yet: every line, but of each
// value the latest alone. No threads and no sockets.
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "ocean/bridge/line_client.hpp"

namespace ocean::bridge {

class ClientEvents {
  public:
    bool empty() const { return events_.empty(); }
    /// Hands over all, in order.
    std::vector<ClientEvent> take();
    /// A value takes the place of the one before it, unless another writer has come between them:
    /// then the latest of both writers stays. Of other lines the oldest goes where there are too
    /// many.
    void add(ClientEvent event);
    /// Removes the values of a name.
    void drop_values(const std::string& name);

  private:
    void keep_one_of(const std::string& name);
    void index_values();

    std::vector<ClientEvent> events_;
    std::map<std::string, std::size_t> value_at_;  // of events_, the latest of a name
    std::set<std::string> turned_;                 // names that have another writer since that
    std::size_t line_count_ = 0;
};

}  // namespace ocean::bridge
