// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A program's end of the line protocol: a thread that keeps the connection, comes back when the
// bridge does, and hands over what was said when its owner asks for it.
#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/bridge/endpoint.hpp"

namespace ocean::bridge {

struct LineClientOptions {
    Endpoint server = {};
    std::string token = {};  // "" = none
    bool subscribe = true;
    std::vector<std::string> names = {};  // to subscribe to; none = all
};

/// What the bridge said, or what became of it. Names are full paths, whatever they were asked by.
struct ClientEvent {
    enum class Kind {
        connected,  // name: this client, as the bridge names it; text: the greeting; values follow
        lost,       // text: why; what there is holds, and it tries again
        value,      // name, text: of a snapshot or a change
        writer,     // name, text: who moves it now
        notice,     // text: an event of the bridge, such as "TAKE take_1.take"
        refused,    // text: "CODE ..." of what was asked
        reply,      // text: any other line
    };
    Kind kind;
    std::string name = {};
    std::string text = {};
};

/// Every function from any thread; none waits for the network.
class LineClient {
  public:
    explicit LineClient(LineClientOptions options);
    ~LineClient();
    LineClient(const LineClient&) = delete;
    LineClient& operator=(const LineClient&) = delete;

    bool connected() const;
    /// What has come since the last call, in order; of a value that came often the latest, of one
    /// that two have moved in turn the latest of each. While a set() of a value is on its way,
    /// older words of the bridge about it are left out.
    std::vector<ClientEvent> events();
    /// The same, after waiting for something to be there.
    std::vector<ClientEvent> wait(std::chrono::milliseconds longest);

    /// The bridge is to have this value: of several for one name the latest is sent, and of those
    /// while there is no connection too, when there is.
    void set(const std::string& name, const std::string& value);
    /// So it stands here: as set(), but what another has wished of it meanwhile is heard.
    void report(const std::string& name, const std::string& value);
    /// Any line, as it is; dropped while there is no connection.
    void send(const std::string& line);

  private:
    class Core;
    std::unique_ptr<Core> core_;
};

}  // namespace ocean::bridge
