// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A program's end: values arrive, set ones are sent, and a bridge that goes and comes back costs
// neither.
#include "ocean/internal/bridge/line_client.hpp"

#include "helpers.hpp"
#include "testing.hpp"

namespace ocean::bridge::test {
namespace {

using namespace std::chrono_literals;
using Kind = ClientEvent::Kind;

/// The first event of that kind and name.
std::optional<ClientEvent> wait_for(LineClient& client, Kind kind, const std::string& name = "",
                                    const std::string& text = "") {
    const auto end = Clock::now() + std::chrono::milliseconds(kPatience);
    while (Clock::now() < end) {
        for (const ClientEvent& event : client.wait(100ms)) {
            const bool this_one = event.kind == kind && (name.empty() || event.name == name) &&
                                  (text.empty() || event.text == text);
            if (this_one) return event;
        }
    }
    return std::nullopt;
}

TEST(LineClient, HandsOverSnapshotAndChanges) {
    const Served served({}, kKnob);
    LineClient client({.server = served.server.endpoint(), .names = {"wind_speed"}});
    EXPECT_TRUE(wait_for(client, Kind::value, "waves.0.wind_speed", "unset"));
    served.turn(0);
    served.turn(14);
    EXPECT_TRUE(wait_for(client, Kind::value, "waves.0.wind_speed", "14"));
    EXPECT_TRUE(client.connected());
}

TEST(LineClient, SetsTheLatestAndHearsNoEcho) {
    const Served served({}, kKnob);
    RawClient raw = served.client();
    raw.ask("SUBSCRIBE wind_speed");
    LineClient client({.server = served.server.endpoint()});
    for (int i = 1; i <= 1000; ++i) client.set("wind_speed", std::to_string(i % 30 + 0.5));
    client.set("wind_speed", "33");
    EXPECT_EQ(raw.line_with("UPD wind_speed 33"), "UPD wind_speed 33");
    raw.ask("SET wind_speed 44");
    // No earlier value arrives after the last one that was set.
    std::vector<std::string> seen;
    const auto end = Clock::now() + std::chrono::milliseconds(kPatience);
    while ((seen.empty() || seen.back() != "44") && Clock::now() < end) {
        for (const ClientEvent& event : client.wait(100ms)) {
            if (event.kind == Kind::value && event.name == "waves.0.wind_speed") {
                seen.push_back(event.text);
            }
        }
    }
    ASSERT_FALSE(seen.empty());
    EXPECT_EQ(seen.back(), "44");
    for (std::size_t i = 0; i + 1 < seen.size(); ++i) EXPECT_TRUE(seen[i] == "33") << seen[i];
}

TEST(LineClient, WhatItReportsTakesNoWishAway) {
    const Served served({}, kKnob);
    LineClient client({.server = served.server.endpoint(), .names = {"app.time"}});
    const auto joined = wait_for(client, Kind::connected);
    ASSERT_TRUE(joined);
    RawClient raw = served.client();
    raw.ask("SUBSCRIBE app.time app.frame_rate");
    client.report("app.frame_rate", "5");
    client.report("app.time", "1");
    EXPECT_EQ(raw.line_with("UPD app.time 1"), "UPD app.time 1");
    raw.send("SET app.time 50\n");
    EXPECT_EQ(raw.line_with("UPD app.time 50"), "UPD app.time 50");
    // Its owner, who draws a long frame, hears of the wish after it has said how its clock was.
    // The line has heard of it when it sends the second of two values of a name: that goes out when
    // the first one is answered, and the answer follows the wish.
    for (const std::string rate : {"6", "7"}) {
        client.report("app.frame_rate", rate);
        ASSERT_EQ(raw.line_with("UPD app.frame_rate " + rate), "UPD app.frame_rate " + rate);
    }
    client.report("app.time", "2");
    client.report("app.time", "3");
    EXPECT_EQ(raw.line_with("UPD app.time 3"), "UPD app.time 3");
    std::string writer, wished;
    for (const ClientEvent& event : client.events()) {
        if (event.name != "app.time") continue;
        if (event.kind == Kind::writer) writer = event.text;
        if (event.kind == Kind::value && event.text == "50") wished = writer;
    }
    EXPECT_FALSE(wished.empty());
    EXPECT_NE(wished, joined->name);
}

TEST(LineClient, ComesBackWithWhatWasSetMeanwhile) {
    auto served = std::make_unique<Served>(ServerOptions{}, kKnob);
    const Endpoint endpoint = served->server.endpoint();
    LineClient client({.server = endpoint, .names = {"wind_speed"}});
    ASSERT_TRUE(wait_for(client, Kind::connected));
    served.reset();
    ASSERT_TRUE(wait_for(client, Kind::lost));
    EXPECT_FALSE(client.connected());
    client.set("wind_speed", "21");
    ServerOptions again;
    again.listen = endpoint;
    served = std::make_unique<Served>(again, kKnob);
    EXPECT_TRUE(wait_for(client, Kind::value, "waves.0.wind_speed", "21"));
}

TEST(LineClient, AWrongValueIsRefusedAndTheLineLives) {
    const Served served({.token = "0123456789abcdef"}, kKnob);
    LineClient client({.server = served.server.endpoint(), .token = "0123456789abcdef"});
    ASSERT_TRUE(wait_for(client, Kind::connected));
    client.set("wind_speed", "1000");
    const auto refused = wait_for(client, Kind::refused);
    ASSERT_TRUE(refused);
    EXPECT_TRUE(refused->text.starts_with("RANGE ")) << refused->text;
    client.set("wind_speed", "1\nQUIT");  // is not sent
    client.set("wind_speed", "12");
    EXPECT_TRUE(wait_for(client, Kind::value, "waves.0.wind_speed", "12"));
}

TEST(LineClient, EndsAtOnceWhereNobodyListens) {
    for (const char* host : {"127.0.0.1", "192.0.2.1", "nowhere.invalid"}) {
        const LineClient client({.server = {host, 9}});
        EXPECT_FALSE(client.connected());
    }
}

TEST(LineClient, WhatIsNoBridgeIsLeft) {
    const int listener = ::socket(AF_INET, SOCK_STREAM, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    ASSERT_EQ(::bind(listener, reinterpret_cast<sockaddr*>(&address), size), 0);
    ASSERT_EQ(::listen(listener, 5), 0);
    ::getsockname(listener, reinterpret_cast<sockaddr*>(&address), &size);
    LineClient client({.server = {"127.0.0.1", ntohs(address.sin_port)}});
    const int other = ::accept(listener, nullptr, nullptr);
    ASSERT_EQ(::send(other, "SSH-2.0-x\r\n", 11, MSG_NOSIGNAL), 11);
    const auto lost = wait_for(client, Kind::lost);
    ASSERT_TRUE(lost);
    EXPECT_EQ(lost->text, "not a bridge; it answers: SSH-2.0-x");
    ::close(other);
    ::close(listener);
}

}  // namespace
}  // namespace ocean::bridge::test
