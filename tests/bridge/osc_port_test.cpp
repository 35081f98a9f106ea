// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Open Sound Control with real sockets: who may set what, who is told what and how often, and that
// nothing that comes by UDP harms the rest.
#include <gtest/gtest.h>

#include <mutex>
#include <thread>

#include "helpers.hpp"
#include "osc_message.hpp"
#include "refusal.hpp"

namespace ocean::bridge::test {
namespace {

using namespace std::chrono_literals;

const std::string kWind = "/ocean/waves/0/wind_speed";

/// A socket of UDP at an address of its own.
class OscPeer {
  public:
    explicit OscPeer(const char* address = "127.0.0.1") : address_(address) {
        descriptor_ = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
        sockaddr_in local = socket_address(address, 0);
        EXPECT_EQ(::bind(descriptor_, reinterpret_cast<sockaddr*>(&local), sizeof local), 0);
        socklen_t size = sizeof local;
        ::getsockname(descriptor_, reinterpret_cast<sockaddr*>(&local), &size);
        port_ = ntohs(local.sin_port);
    }
    OscPeer(const OscPeer&) = delete;
    OscPeer& operator=(const OscPeer&) = delete;
    ~OscPeer() { ::close(descriptor_); }

    Endpoint endpoint() const { return {address_, port_}; }
    void send(std::string_view packet, const Served& served) const {
        const sockaddr_in to = socket_address("127.0.0.1", served.server.osc_endpoint()->port);
        ::sendto(descriptor_, packet.data(), packet.size(), 0,
                 reinterpret_cast<const sockaddr*>(&to), sizeof to);
    }
    void send(const std::string& address, std::vector<OscArgument> arguments,
              const Served& served) const {
        send(osc_packet({address, std::move(arguments)}), served);
    }
    /// The messages of the next packet; none if no packet comes.
    std::vector<OscMessage> next(int milliseconds = kPatience) const {
        pollfd waits{descriptor_, POLLIN, 0};
        if (::poll(&waits, 1, milliseconds) <= 0) return {};
        char block[65536];
        const auto count = ::recv(descriptor_, block, sizeof block, 0);
        return parse_osc_packet({block, static_cast<std::size_t>(count)}).messages;
    }
    /// The next value of an address.
    std::string value(const std::string& address) const {
        for (;;) {
            const auto messages = next();
            if (messages.empty()) return "(nothing)";
            for (const OscMessage& message : messages) {
                if (message.address == address) return osc_text(message.arguments.at(0));
            }
        }
    }

  private:
    static sockaddr_in socket_address(const char* address, unsigned short port) {
        sockaddr_in full{};
        full.sin_family = AF_INET;
        full.sin_port = htons(port);
        ::inet_pton(AF_INET, address, &full.sin_addr);
        return full;
    }
    int descriptor_;
    std::string address_;
    unsigned short port_ = 0;
};

/// The log of a bridge, which another thread writes.
class SharedLog {
  public:
    std::function<void(std::string)> writer() {
        return [this](const std::string& line) {
            const std::lock_guard lock(mutex_);
            text_ += line + "\n";
        };
    }
    std::size_t count(std::string_view part) {
        const std::lock_guard lock(mutex_);
        std::size_t found = 0;
        for (std::size_t at = 0; (at = text_.find(part, at)) != std::string::npos; ++at) ++found;
        return found;
    }
    bool waits_for(std::string_view part) {
        const auto end = Clock::now() + std::chrono::milliseconds(kPatience);
        while (count(part) == 0 && Clock::now() < end) std::this_thread::sleep_for(1ms);
        return count(part) > 0;
    }

  private:
    std::mutex mutex_;
    std::string text_;
};

ServerOptions with_osc(std::vector<Endpoint> to = {}, SharedLog* log = nullptr) {
    ServerOptions options;
    options.osc = {.listen = Endpoint{"127.0.0.1", 0}, .to = std::move(to)};
    if (log != nullptr) options.log = log->writer();
    return options;
}

TEST(OscPort, AMessageSetsAValueAndIsItsWriter) {
    const Served served(with_osc(), kKnob);
    RawClient client = served.client();
    EXPECT_EQ(client.ask("SUBSCRIBE wind_speed spectrum app.pause"), "OK");
    for (int i = 0; i < 3; ++i) client.line_with("VAL");
    const OscPeer peer;
    peer.send("/ocean/wind_speed", {14.1f}, served);
    EXPECT_EQ(client.line(), "EVT WRITER wind_speed osc:127.0.0.1");
    EXPECT_EQ(client.line(), "UPD wind_speed 14.1");
    // Another port of the same address is the same writer.
    OscPeer().send("/ocean/waves.0.wind_speed", {std::int64_t{15}}, served);
    EXPECT_EQ(client.line(), "UPD wind_speed 15");
    peer.send("/ocean/waves/0/spectrum", {std::string("jonswap")}, served);
    EXPECT_EQ(client.line(), "EVT WRITER spectrum osc:127.0.0.1");
    EXPECT_EQ(client.line(), "UPD spectrum jonswap");
    peer.send("/ocean/app/pause", {true}, served);
    EXPECT_EQ(client.line(), "EVT WRITER app.pause osc:127.0.0.1");
    EXPECT_EQ(client.line(), "UPD app.pause 1");
}

/// As a tablet's page sends them: a picture for another program beside a value of the sea.
TEST(OscPort, ABundleDeliversItsOwnBesideWhatIsForOthers) {
    using namespace std::string_literals;
    SharedLog log;
    const Served served(with_osc({}, &log), kKnob);
    RawClient client = served.client();
    EXPECT_EQ(client.ask("SUBSCRIBE wind_speed"), "OK");
    EXPECT_EQ(client.line(), "VAL wind_speed unset");
    const OscPeer peer;
    peer.send(
        "#bundle\0\0\0\0\0\0\0\0\1"s
        "\0\0\0\x1c/page/picture\0\0\0,b\0\0\0\0\0\4abcd"s
        "\0\0\0\x1c/ocean/wind_speed\0\0\0,f\0\0\x41\x60\0\0"s,
        served);
    ASSERT_EQ(client.line(), "EVT WRITER wind_speed osc:127.0.0.1");
    EXPECT_EQ(client.line(), "UPD wind_speed 14");
    EXPECT_TRUE(log.waits_for(
        "/page/picture: its arguments have the types b; allowed: i, h, f, d, s, S, T, F"));
}

TEST(OscPort, AMessageWithoutArgumentsAsksForTheValue) {
    const Served served(with_osc(), kKnob);
    const OscPeer peer;
    const std::vector<std::pair<std::string, OscArgument>> expected = {
        {"/ocean/fetch", 300000.0f},
        {"/ocean/grid/resolution", std::int64_t{512}},
        {"/ocean/app/pause", std::int64_t{0}},
        {"/ocean/app/speed", 1.0f},
        {"/ocean/spectrum", std::string("phillips")},
        {"/ocean/wind_speed", std::string("unset")},
        {"/ocean/water/depth", std::numeric_limits<float>::infinity()}};
    for (const auto& [address, argument] : expected) {
        peer.send(address, {}, served);
        const auto answer = peer.next();
        ASSERT_EQ(answer.size(), 1u) << address;
        EXPECT_EQ(answer[0].address, address);
        EXPECT_EQ(answer[0].arguments, std::vector<OscArgument>{argument}) << address;
    }
}

TEST(OscPort, TargetsGetASnapshotThenChangesAndNobodyAnEcho) {
    const OscPeer tablet("127.0.0.1");
    const OscPeer desk("127.0.0.2");
    const Served served(with_osc({tablet.endpoint(), desk.endpoint()}), kKnob);
    std::size_t values = 0;
    while (values < served.hub.values().entries().size()) {
        const auto messages = tablet.next();
        ASSERT_FALSE(messages.empty());
        values += messages.size();
    }
    EXPECT_EQ(values, served.hub.values().entries().size());
    EXPECT_EQ(desk.value(kWind), "unset");
    // A tablet sends from another port than it listens at.
    OscPeer("127.0.0.1").send("/ocean/wind_speed", {14.0f}, served);
    EXPECT_EQ(desk.value(kWind), "14");
    RawClient client = served.client();
    EXPECT_EQ(client.ask("SET wind_speed 15"), "OK");
    EXPECT_EQ(desk.value(kWind), "15");
    EXPECT_EQ(tablet.value(kWind), "15");  // and 14 never
    desk.send("/ocean/wind_speed", {16.0f}, served);
    EXPECT_EQ(tablet.value(kWind), "16");
    EXPECT_EQ(client.ask("SET choppiness 0.5"), "OK");
    const auto last = desk.next();
    ASSERT_EQ(last.size(), 1u);
    EXPECT_EQ(last[0].address, "/ocean/surface/choppiness");
}

TEST(OscPort, ChangesGoOutAtMostSixtyTimesASecondAndTheLastArrives) {
    const OscPeer tablet;
    const Served served(with_osc({tablet.endpoint()}), kKnob);
    EXPECT_EQ(tablet.value("/ocean/app/frame_rate"), "0");  // the end of the snapshot
    served.turn(0);
    const auto start = Clock::now();
    std::thread hand([&] {
        for (int i = 1; i <= 1000; ++i) {
            served.turn(0.05 * i);
            std::this_thread::sleep_for(1ms);
        }
    });
    int packets = 0;
    std::string value;
    while (value != "50" && value != "(nothing)") {
        value = tablet.value(kWind);
        ++packets;
    }
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
    hand.join();
    EXPECT_EQ(value, "50");
    EXPECT_LE(packets, 60.0 * seconds + 2.0);
    EXPECT_GE(packets, 3);
}

TEST(OscPort, BundlesAreSetAsAWholeAndEachBadValueAlone) {
    SharedLog log;
    const Served served(with_osc({}, &log), kKnob);
    RawClient client = served.client();
    const OscPeer peer;
    std::string inner = osc_bundles(
        std::vector<OscMessage>{{"/ocean/wind_speed", {99.0f}}, {"/ocean/fetch", {2e5}}})[0];
    // A broken packet has no effect.
    peer.send(inner.substr(0, inner.size() - 4), served);
    EXPECT_TRUE(log.waits_for("do not fit"));
    EXPECT_EQ(client.ask("GET fetch"), "VAL fetch 300000");
    std::string outer = osc_bundles(std::vector<OscMessage>{{"/ocean/choppiness", {0.5f}}})[0];
    outer += std::string("\0\0\0", 3) + static_cast<char>(inner.size()) + inner;
    peer.send(outer, served);
    peer.send("/ocean/app/time", {}, served);
    EXPECT_EQ(peer.next().size(), 1u);
    EXPECT_EQ(client.ask("GET fetch"), "VAL fetch 200000");
    EXPECT_EQ(client.ask("GET choppiness"), "VAL choppiness 0.5");
    EXPECT_EQ(client.ask("GET wind_speed"), "VAL wind_speed unset");
}

TEST(OscPort, OthersThanTheAllowedAreDroppedCountedAndSaidOnce) {
    SharedLog log;
    {
        ServerOptions options;
        options.osc = {.listen = Endpoint{"0.0.0.0", 0}, .allow = {"127.0.0.1"}};
        options.log = log.writer();
        const Served served(std::move(options), kKnob);
        const OscPeer stranger("127.0.0.2");
        for (int i = 0; i < 3; ++i) stranger.send("/ocean/wind_speed", {20.0f}, served);
        stranger.send("/ocean/fetch", {}, served);
        const OscPeer peer;
        peer.send("/ocean/wind_speed", {}, served);
        EXPECT_EQ(peer.value("/ocean/wind_speed"), "unset");
        EXPECT_TRUE(stranger.next(0).empty());
    }
    EXPECT_EQ(log.count(", from 127.0.0.1\n"), 1u);
    EXPECT_EQ(log.count("osc 127.0.0.2 is not allowed; its packets are dropped\n"), 1u);
    EXPECT_EQ(log.count("osc: 4 packets of addresses that are not allowed were dropped"), 1u);
}

/// Who is allowed by an address of IPv4 comes to a socket of IPv6 by another form of it.
TEST(OscPort, AnAddressIsTheSameAtASocketOfIpv6) {
    ServerOptions options;
    options.osc = {.listen = Endpoint{"::", 0}, .allow = {"127.0.0.1"}};
    std::optional<Served> served;
    try {
        served.emplace(std::move(options), kKnob);
    } catch (const Error& error) {
        GTEST_SKIP() << error.what();
    }
    RawClient client = served->client();
    EXPECT_EQ(client.ask("SUBSCRIBE choppiness"), "OK");
    client.line();
    OscPeer("127.0.0.2").send("/ocean/choppiness", {0.7f}, *served);
    OscPeer("127.0.0.1").send("/ocean/choppiness", {0.5f}, *served);
    EXPECT_EQ(client.line(), "EVT WRITER choppiness osc:127.0.0.1");
    EXPECT_EQ(client.line(), "UPD choppiness 0.5");
}

TEST(OscPort, WhatCannotBeIsRefusedAtTheStart) {
    const auto is_refused = [](const std::string& says, const OscOptions& osc) {
        return ocean::test::message_of([&] { const Served served({.osc = osc}); }).find(says) !=
               std::string::npos;
    };
    const Endpoint here{"127.0.0.1", 0};
    const Endpoint tablet{"tablet", 0};
    const OscPeer taken;
    EXPECT_TRUE(is_refused("--osc-allow", {.listen = Endpoint{"0.0.0.0", 0}}));
    EXPECT_TRUE(is_refused("add --osc", {.allow = {"127.0.0.1"}}));
    EXPECT_TRUE(is_refused("is not an address", {.listen = here, .allow = {"tablet"}}));
    EXPECT_TRUE(is_refused("is not an address", {.listen = tablet}));
    EXPECT_TRUE(is_refused("is not an address", {.to = {{"tablet", 9000}}}));
    EXPECT_TRUE(is_refused("for OSC: Address already in use", {.listen = taken.endpoint()}));
}

TEST(OscPort, SubscribersAreToldUntilTheyAreGone) {
    const OscPeer desk("127.0.0.2");
    const OscPeer other("127.0.0.3");
    const auto subscribe = [&](const Served& served) {
        desk.send("/ocean/subscribe", {}, served);
        OscPeer("127.0.0.3")
            .send("/ocean/subscribe", {std::int64_t{other.endpoint().port}}, served);
    };
    {
        const Served served(with_osc(), kKnob);
        subscribe(served);
        EXPECT_EQ(desk.value(kWind), "unset");
        EXPECT_EQ(other.value(kWind), "unset");
        served.turn(0);
        served.turn(14);
        EXPECT_EQ(desk.value(kWind), "14");
        EXPECT_EQ(other.value(kWind), "14");
    }
    SharedLog log;
    const OscPeer tablet;
    ServerOptions options = with_osc({tablet.endpoint()}, &log);
    options.osc.subscription = 1ms;
    const Served served(std::move(options), kKnob);
    subscribe(served);
    EXPECT_TRUE(log.waits_for("osc " + desk.endpoint().text() + "'s subscription has ended"));
    EXPECT_TRUE(log.waits_for("osc " + other.endpoint().text() + "'s subscription has ended"));
    while (!desk.next(0).empty()) continue;  // of before
    served.turn(0);
    served.turn(15);
    // Who is still told is told, and then the bridge answers a client.
    EXPECT_EQ(tablet.value(kWind), "unset");
    EXPECT_EQ(tablet.value(kWind), "15");
    EXPECT_EQ(served.client().ask("PING"), "OK");
    EXPECT_TRUE(desk.next(0).empty());
    desk.send("/ocean/wind_speed", {}, served);
    EXPECT_EQ(desk.value("/ocean/wind_speed"), "15");
}

TEST(OscPort, OnlySixteenSubscribe) {
    SharedLog log;
    const Served served(with_osc({}, &log), kKnob);
    const OscPeer peer;
    for (std::int64_t port = 20001; port <= 20018; ++port) {
        peer.send("/ocean/subscribe", {port}, served);
    }
    peer.send("/ocean/subscribe", {std::int64_t{20001}}, served);  // again is no other
    peer.send("/ocean/fetch", {}, served);
    EXPECT_EQ(peer.value("/ocean/fetch"), "300000");
    EXPECT_EQ(log.count("subscribes\n"), 16u);
    EXPECT_EQ(log.count("the max number of subscribers is 16"), 1u);
}

TEST(OscPort, ATargetThatCannotBeToldIsNamedOnceAndStopsNobody) {
    SharedLog log;
    const OscPeer tablet;
    // Broadcasts need a right that the socket does not ask for.
    const Served served(with_osc({{"255.255.255.255", 9000}, tablet.endpoint()}, &log), kKnob);
    EXPECT_EQ(tablet.value(kWind), "unset");
    served.turn(0);
    for (const double wind : {14.0, 15.0, 16.0}) {
        served.turn(wind);
        EXPECT_EQ(tablet.value(kWind), osc_text(wind));
    }
    EXPECT_EQ(log.count("osc 255.255.255.255:9000 cannot be reached"), 1u);
}

TEST(OscPort, FramesAreSaidByWhoShowsThem) {
    SharedLog log;
    const Served served(with_osc({}, &log), kKnob);
    OscPeer().send("/ocean/app/frame_rate", {60.0f}, served);
    EXPECT_TRUE(log.waits_for("over TCP"));
    RawClient client = served.client();
    EXPECT_EQ(client.ask("GET app.frame_rate"), "VAL app.frame_rate 0");
}

TEST(OscPort, AFloodOfRubbishFillsNoLogAndChangesNothing) {
    SharedLog log;
    const Served served(with_osc({}, &log), kKnob);
    RawClient client = served.client();
    const OscPeer peer;
    const std::string good = osc_packet({"/ocean/wind_speed", {20.0f}});
    std::uint32_t random = 1;
    for (int i = 0; i < 20'000; ++i) {
        std::string packet = good;
        random = random * 1664525u + 1013904223u;
        packet[(random >> 8) % 8] = static_cast<char>(random >> 24 | 0x80);  // of the address
        packet.resize(i % 3 == 0 ? (random >> 16) % packet.size() : packet.size());
        peer.send(packet, served);
        if (i % 100 == 0) {
            ASSERT_EQ(client.ask("PING"), "OK");
        }
    }
    EXPECT_EQ(client.ask("GET wind_speed"), "VAL wind_speed unset");
    // The first, and then fewer and fewer: 1, 3, 7 s later.
    EXPECT_LE(log.count("osc 127.0.0.1:"), 8u);
    // The system may still hold so much of the flood that it drops what comes.
    std::string value;
    for (int tries = 0; value != "20" && tries < kPatience / 100; ++tries) {
        peer.send(good, served);
        peer.send("/ocean/wind_speed", {}, served);
        const auto answer = peer.next(100);
        if (!answer.empty()) value = osc_text(answer[0].arguments.at(0));
    }
    EXPECT_EQ(value, "20");
}

}  // namespace
}  // namespace ocean::bridge::test
