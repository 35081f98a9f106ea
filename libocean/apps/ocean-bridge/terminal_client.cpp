// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "terminal_client.hpp"

#include <utility>
#include <variant>
#include <vector>

#include "console.hpp"
#include "interrupt.hpp"
#include "line_input.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/bridge/line_client.hpp"
#include "ocean/internal/bridge/line_protocol.hpp"
#include "ocean/internal/checked_text.hpp"

namespace ocean::app {
namespace {

using Kind = bridge::ClientEvent::Kind;

std::string shown(const bridge::ClientEvent& event) {
    switch (event.kind) {
        case Kind::value:
            return event.name + " = " + event.text;
        case Kind::writer:
            return event.name + " is set by " + event.text;
        case Kind::lost:
            return "(no bridge: " + event.text + ")";
        case Kind::refused:
            return "ERR " + event.text;
        case Kind::connected:
        case Kind::notice:
        case Kind::reply:
            break;
    }
    return event.text;
}

bool asks_to_quit(const std::string& line) {
    const auto parsed = bridge::parse_request(line);
    const auto* request = parsed ? std::get_if<bridge::Request>(&*parsed) : nullptr;
    return request != nullptr && request->verb == bridge::Verb::quit;
}

}  // namespace

void run_terminal_client(const bridge::Endpoint& server, const std::string& token,
                         const Context& context) {
    constexpr int kPollInterval = 20;  // [ms]

    LineInput input;
    const InterruptWatch::LastAct last(context.interrupts, [&input] { input.restore(); });
    bridge::LineClient client({.server = server, .token = token, .subscribe = false});
    std::vector<std::string> unsent;  // lines typed before the connection
    std::string failure;              // the reason for no connection
    bool was_connected = false;
    bool leaving = false;
    for (;;) {
        for (std::string& line : input.wait(kPollInterval)) unsent.push_back(std::move(line));
        if (client.connected()) {
            for (const std::string& line : unsent) {
                client.send(line);
                leaving = leaving || asks_to_quit(line);
            }
            unsent.clear();
            if (input.ended() && !leaving) {
                leaving = true;
                client.send("QUIT");
            }
        }
        const auto events = client.events();
        if (!events.empty()) input.hide();
        for (const bridge::ClientEvent& event : events) {
            context.console.data(text::printable(shown(event), 1000) + "\n");
            was_connected = was_connected || event.kind == Kind::connected;
            if (event.kind != Kind::lost) continue;
            if (leaving) return input.restore();
            failure = event.text;
        }
        // Input of a pipe does not wait for a bridge.
        if (input.ended() && !was_connected && !failure.empty()) {
            throw Error(ErrorKind::output, server.text() + ": " + failure);
        }
        if (!events.empty()) input.show();
    }
}

}  // namespace ocean::app
