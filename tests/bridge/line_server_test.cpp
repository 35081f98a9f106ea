// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The server with real sockets: what each command does, what hostile clients do not do, and that
// nothing is left behind.
#include "ocean/internal/bridge/line_server.hpp"

#include <gtest/gtest.h>

#include <future>
#include <mutex>
#include <thread>

#include "helpers.hpp"
#include "ocean/error.hpp"

namespace ocean::bridge::test {
namespace {

using namespace std::chrono_literals;

const std::string kKnobAndLamp =
    kKnob + "[[out]]\nfrom = \"app.frame_rate\"\nto = \"board0/dac1\"\nin = [0, 255]\n";

/// Waits for what other threads bring about.
template <typename Condition>
bool comes_true(const Condition& condition) {
    const auto end = Clock::now() + std::chrono::milliseconds(kPatience);
    do {
        if (condition()) return true;
        std::this_thread::sleep_for(1ms);
    } while (Clock::now() < end);
    return false;
}

TEST(LineServer, GreetsAndAnswersEachCommand) {
    const Served served({}, kKnobAndLamp);
    RawClient raw(served.server.endpoint());
    EXPECT_TRUE(raw.line().starts_with("OBP 1 "));
    EXPECT_EQ(raw.ask("PING"), "OK");
    EXPECT_EQ(raw.ask("GET choppiness"), "VAL choppiness 1");
    EXPECT_EQ(raw.ask("set choppiness 0.5"), "OK");
    EXPECT_EQ(raw.ask("GET surface.choppiness"), "VAL surface.choppiness 0.5");
    EXPECT_EQ(raw.ask("SET choppiness 9"),
              "ERR RANGE surface.choppiness = 9: is out of range; allowed: 0 .. 4");
    EXPECT_TRUE(raw.ask("GET choppines").starts_with("ERR UNKNOWN-NAME "));
    EXPECT_TRUE(raw.ask("SET file x").starts_with("ERR READONLY "));
    EXPECT_TRUE(raw.ask("OUT board9/o1 1").starts_with("ERR UNKNOWN-NAME "));
    EXPECT_EQ(raw.ask("OUT board0/dac1 nan"), "ERR RANGE 'nan' is not a number");
    EXPECT_EQ(raw.ask("RECORD"), "ERR USAGE RECORD START|STOP [FILE]");
    EXPECT_EQ(raw.ask("RECORD STOP"), "ERR RANGE nothing is being recorded");
    EXPECT_TRUE(raw.ask("FLY").starts_with("ERR UNKNOWN-COMMAND "));
    EXPECT_EQ(raw.ask("HELP"), "BEGIN HELP");
    EXPECT_EQ(raw.line_with("END"), "END HELP");
    EXPECT_EQ(raw.ask("LIST"), "BEGIN LIST");
    std::size_t names = 0;
    for (std::string line = raw.line(); line != "END LIST"; line = raw.line()) {
        EXPECT_TRUE(line.starts_with("VAL ")) << line;
        ++names;
    }
    EXPECT_EQ(names, served.hub.values().entries().size());
    EXPECT_EQ(raw.ask("QUIT"), "OK");
    EXPECT_EQ(raw.line(), "");
}

TEST(LineServer, AKnobReachesWhoSubscribes) {
    const Served served({}, kKnobAndLamp);
    RawClient raw = served.client();
    EXPECT_EQ(raw.ask("SUBSCRIBE wind_speed"), "OK");
    EXPECT_EQ(raw.line(), "VAL wind_speed unset");
    served.turn(0);
    served.turn(14);
    EXPECT_EQ(raw.line(), "EVT WRITER wind_speed board0/a1");
    EXPECT_EQ(raw.line(), "UPD wind_speed 14");
    RawClient other = served.client();
    EXPECT_EQ(other.ask("SET wind_speed 20"), "OK");
    EXPECT_TRUE(raw.line().starts_with("EVT WRITER wind_speed 127.0.0.1:"));
    EXPECT_EQ(raw.line(), "UPD wind_speed 20");
    // A snapshot is what is now, and is not told again.
    EXPECT_EQ(other.ask("SUBSCRIBE waves.0.wind_speed"), "OK");
    EXPECT_TRUE(other.line().starts_with("EVT WRITER waves.0.wind_speed 127.0.0.1:"));
    EXPECT_EQ(other.line(), "VAL waves.0.wind_speed 20");
    EXPECT_EQ(raw.ask("UNSUBSCRIBE"), "OK");
    served.turn(30);
    EXPECT_EQ(other.line(), "EVT WRITER waves.0.wind_speed board0/a1");
    EXPECT_EQ(other.line(), "UPD waves.0.wind_speed 30");
    EXPECT_EQ(raw.ask("PING"), "OK");
}

TEST(LineServer, WhoShowsTheSeaIsToldOfEachWish) {
    const Served served({}, kKnobAndLamp);
    RawClient shows = served.client();
    RawClient hand = served.client();
    EXPECT_EQ(shows.ask("SET app.frame_rate 60"), "OK");
    EXPECT_EQ(shows.ask("SET app.time 1"), "OK");
    EXPECT_EQ(shows.ask("SUBSCRIBE app.time"), "OK");
    for (int wish = 100; wish < 150; ++wish) {
        // It tells its clock while the wish is on its way.
        EXPECT_EQ(hand.ask("SET app.time " + std::to_string(wish)), "OK");
        shows.send("SET app.time 1\n");
        EXPECT_EQ(shows.line_with("UPD app.time " + std::to_string(wish)),
                  "UPD app.time " + std::to_string(wish));
    }
    // A value that the program does not own belongs to its last writer, as always.
    RawClient both = served.client();
    EXPECT_EQ(both.ask("SUBSCRIBE choppiness"), "OK");
    for (int i = 0; i < 50; ++i) {
        EXPECT_EQ(hand.ask("SET choppiness 0.5"), "OK");
        both.send("SET choppiness 1.5\nGET choppiness\n");
        EXPECT_EQ(both.line_with("VAL choppiness 1.5"), "VAL choppiness 1.5");
    }
}

TEST(LineServer, ALampFollowsAValue) {
    const Served served({}, kKnobAndLamp);
    RawClient raw = served.client();
    EXPECT_EQ(raw.ask("SET app.frame_rate 60"), "OK");
    EXPECT_EQ(raw.ask("PING"), "OK");
    ASSERT_FALSE(served.board->told.empty());
    EXPECT_EQ(served.board->told.back(), (std::pair<std::string, double>("board0/dac1", 60.0)));
}

TEST(LineServer, HostileLinesAreAnsweredAndHarmNobody) {
    const Served served({.commands_per_second = 1e6}, kKnobAndLamp);
    RawClient raw = served.client();
    raw.send(std::string(100'000, 'a') + "\n");
    EXPECT_EQ(raw.line(), "ERR TOO-LONG a line has at most 1024 bytes");
    raw.send("\xFF\xFE\x01\xC3(\n");
    EXPECT_TRUE(raw.line().starts_with("ERR BAD-UTF8 "));
    EXPECT_TRUE(raw.ask("SET wind_speed 1e309").starts_with("ERR RANGE "));
    EXPECT_TRUE(raw.ask("SET wind_speed nan").starts_with("ERR RANGE "));
    EXPECT_TRUE(raw.ask("SET wind_speed \xF0\x9F\x8C\x8A").starts_with("ERR RANGE "));
    raw.send("PI");
    RawClient other = served.client();
    EXPECT_EQ(other.ask("PING"), "OK");
    raw.send("NG\r\n");
    EXPECT_EQ(raw.line(), "OK");
}

/// As the telnet of netkit and PuTTY do it; answers stand in the order of what they answer.
TEST(LineServer, TelnetsInterruptIsAnswered) {
    const Served served({.commands_per_second = 1e6}, kKnobAndLamp);
    RawClient raw = served.client();
    raw.send("PING\r\nSET wind_spe\xFF\xF4\xFF\xFD\x06PING\r\n");
    EXPECT_EQ(raw.line(), "OK");
    EXPECT_EQ(raw.line(), "\xFF\xFC\x06OK");
    // Synch: the Data Mark is urgent, and the byte behind it is no command of telnet.
    raw.send("\xFF\xF4\xFF");
    const char mark = '\xF2';
    ASSERT_EQ(::send(raw.descriptor(), &mark, 1, MSG_OOB), 1);
    EXPECT_EQ(raw.ask("\xFF\xF6PING"), "EVT HERE");
    EXPECT_EQ(raw.line(), "OK");
    // One that asks for ever and reads nothing is held back as any other, and harms nobody.
    RawClient flood = served.client();
    std::string asks;
    for (int i = 0; i < 100'000; ++i) asks += "\xFF\xFD\x06";
    std::size_t sent = 0;
    for (int i = 0; i < 200; ++i) {
        const auto count =
            ::send(flood.descriptor(), asks.data(), asks.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
        if (count > 0) sent += static_cast<std::size_t>(count);
    }
    EXPECT_LT(sent, std::size_t{16} << 20);  // what the system's buffers hold, of 60 MB
    EXPECT_EQ(raw.ask("PING"), "OK");
}

/// Unread commands are not stored: a flood of questions is throttled.
TEST(LineServer, AFloodThatNeverReadsIsHeldBack) {
    const Served served({.commands_per_second = 1e6}, kKnobAndLamp);
    RawClient flood = served.client();
    std::string questions;
    for (int i = 0; i < 400; ++i) questions += "LIST\n";
    std::size_t sent = 0;
    for (int i = 0; i < 20'000; ++i) {
        const auto count = ::send(flood.descriptor(), questions.data(), questions.size(),
                                  MSG_NOSIGNAL | MSG_DONTWAIT);
        if (count > 0) sent += static_cast<std::size_t>(count);
    }
    EXPECT_LT(sent, std::size_t{8} << 20);  // what the system's buffers hold
    RawClient other = served.client();
    EXPECT_EQ(other.ask("PING"), "OK");
    EXPECT_EQ(served.server.clients(), 2u);
}

TEST(LineServer, CommandsThatComeTooFastWait) {
    const Served served({.commands_per_second = 50.0}, kKnobAndLamp);
    RawClient raw = served.client();
    std::string questions;
    for (int i = 0; i < 75; ++i) questions += "PING\n";
    const auto start = Clock::now();
    raw.send(questions);
    for (int i = 0; i < 75; ++i) ASSERT_EQ(raw.line(), "OK");
    // 50 at once, 25 at 50 a second: a busy machine makes it longer, never shorter.
    EXPECT_GE(Clock::now() - start, 400ms);
}

TEST(LineServer, OneClientTooManyIsToldSo) {
    const Served served({.clients = 2}, kKnobAndLamp);
    RawClient first = served.client();
    RawClient second = served.client();
    RawClient third(served.server.endpoint());
    EXPECT_EQ(third.line(), "ERR BUSY the bridge has its max number of clients");
    EXPECT_EQ(third.line(), "");
    second.close();
    EXPECT_TRUE(comes_true([&] { return served.server.clients() == 1; }));
    RawClient fourth(served.server.endpoint());
    EXPECT_TRUE(fourth.line().starts_with("OBP "));
}

TEST(LineServer, WhoSaysNothingIsLetGoAndWhoListensIsNot) {
    const Served served({.idle = 100ms}, kKnobAndLamp);
    RawClient idle = served.client();
    // On a busy machine one that is about to subscribe may be let go before it has.
    std::optional<RawClient> subscriber;
    do {
        subscriber.emplace(served.client());
    } while (subscriber->ask("SUBSCRIBE wind_speed") != "OK");
    RawClient& listener = *subscriber;
    EXPECT_EQ(idle.line(), "ERR IDLE no command for too long");
    EXPECT_EQ(idle.line(), "");
    EXPECT_EQ(listener.ask("PING"), "VAL wind_speed unset");
    EXPECT_EQ(listener.line(), "OK");
}

TEST(LineServer, WhoNeverReadsIsLetGo) {
    const Served served({.stalled = 200ms}, kKnobAndLamp);
    RawClient stalled(served.server.endpoint(), 4096);
    ASSERT_TRUE(stalled.line().starts_with("OBP "));  // it is a client
    // Answers to begin with: of updates alone, which are coalesced, it takes long until nothing
    // more fits between the two.
    for (int i = 0; i < 4; ++i) stalled.send("LIST\n");
    stalled.send("SUBSCRIBE\n");
    served.turn(0);
    double wind = 0.0;
    EXPECT_TRUE(comes_true([&] {
        for (int i = 0; i < 100; ++i) served.turn(wind = wind > 70.0 ? 0.01 : wind + 0.01);
        return served.server.clients() == 0;
    }));
}

TEST(LineServer, ABoardThatFloodsLeavesClientsTheirTurn) {
    const Served served({}, kKnobAndLamp);
    RawClient raw = served.client();
    // The server is held at a lamp until all that the board says and a question wait for it.
    std::promise<void> held;
    std::promise<void> go_on;
    served.board->when_told = [&, once = true]() mutable {
        if (!std::exchange(once, false)) return;
        held.set_value();
        go_on.get_future().wait();
    };
    RawClient other = served.client();
    other.send("SET app.frame_rate 60\n");
    held.get_future().wait();
    constexpr int kReports = 6'000;
    for (int i = 1; i <= kReports; ++i) served.turn(70.0 * i / kReports);
    raw.send("GET wind_speed\n");
    go_on.set_value();
    const std::string answer = raw.line();
    ASSERT_TRUE(answer.starts_with("VAL wind_speed "));
    EXPECT_NE(answer, "VAL wind_speed 70") << "first came all that the board said";
    EXPECT_TRUE(comes_true([&] { return raw.ask("GET wind_speed") == "VAL wind_speed 70"; }));
}

TEST(LineServer, ATokenComesFirst) {
    const Served served({.token = "0123456789abcdef"}, kKnobAndLamp);
    RawClient raw = served.client();
    EXPECT_EQ(raw.ask("PING"), "OK");
    EXPECT_EQ(raw.ask("GET wind_speed"), "ERR AUTH send AUTH TOKEN first");
    EXPECT_EQ(raw.ask("AUTH 0123456789abcdef"), "OK");
    EXPECT_EQ(raw.ask("GET wind_speed"), "VAL wind_speed unset");
    RawClient guesser = served.client();
    const auto start = Clock::now();
    EXPECT_EQ(guesser.ask("AUTH x"), "ERR AUTH wrong token");
    EXPECT_EQ(guesser.ask("AUTH y"), "ERR AUTH wrong token");
    EXPECT_EQ(guesser.ask("AUTH z"), "ERR AUTH wrong token");
    EXPECT_EQ(guesser.line(), "");
    EXPECT_GE(Clock::now() - start, 1900ms);  // a second after each; a busy machine adds to it
}

TEST(LineServer, BeyondThisMachineATokenIsNeeded) {
    Hub hub({}, {});
    EXPECT_THROW(LineServer({.listen = {"0.0.0.0", 0}}, hub), Error);
    EXPECT_THROW(LineServer({.listen = {"example.org", 0}, .token = "0123456789abcdef"}, hub),
                 Error);
    const LineServer with_token({.listen = {"0.0.0.0", 0}, .token = "0123456789abcdef"}, hub);
    EXPECT_NE(with_token.endpoint().port, 0);
}

TEST(LineServer, MoreClientsThanDescriptorsAreRefusedAtTheStart) {
    Hub hub({}, {});
    ServerOptions options{.listen = {"127.0.0.1", 0}, .clients = 100'000'000};
    EXPECT_THROW(LineServer(options, hub), Error);
}

TEST(LineServer, TheLogHasEveryClientAndLineButNoToken) {
    std::mutex mutex;
    std::string log;
    std::string peer;
    {
        ServerOptions options{.token = "0123456789abcdef"};
        options.log = [&](const std::string& line) {
            const std::lock_guard lock(mutex);
            log += line + "\n";
        };
        const Served served(std::move(options), kKnobAndLamp);
        RawClient raw = served.client();
        sockaddr_in address{};
        socklen_t size = sizeof address;
        ::getsockname(raw.descriptor(), reinterpret_cast<sockaddr*>(&address), &size);
        peer = "127.0.0.1:" + std::to_string(ntohs(address.sin_port));
        raw.ask("AUTH 0123456789abcdef");
        raw.ask("SET a \x1B[31m");
        raw.ask("GET wind_speed");
        raw.ask("QUIT");
        raw.line();
    }
    EXPECT_TRUE(log.starts_with("listening on 127.0.0.1:")) << log;
    const std::string expected = peer + " connected\n" + peer + ": AUTH ...\n" + peer +
                                 ": BAD-UTF8\n" + peer + ": GET wind_speed\n" + peer + ": QUIT\n" +
                                 peer + " ended\nstopped\n";
    EXPECT_TRUE(log.ends_with(expected)) << log;
}

TEST(LineServer, TheLogHasHandsAndReportsOnlyOnRequest) {
    const auto log_of = [](bool log_reports) {
        std::mutex mutex;
        std::string log;
        {
            ServerOptions options{.log_reports = log_reports};
            options.log = [&](const std::string& line) {
                const std::lock_guard lock(mutex);
                log += line.substr(line.find(": ") + 1) + "\n";
            };
            const Served served(std::move(options), kKnobAndLamp);
            RawClient hand = served.client();
            RawClient window = served.client();
            for (const char* report : {"SET app.frame_rate 60.0", "SET app.time 1.5",
                                       "SET app.pause 0", "SET app.speed 1"}) {
                window.ask(report);
            }
            window.ask("SET app.pause 1");  // by a key in the window
            window.ask("SET app.pause 1");
            window.ask("SET wind_speed 12");
            hand.ask("SET app.pause 0");  // the hand's request, and the window's echo
            window.ask("SET app.pause 0");
            hand.ask("SET app.time 0");
            hand.ask("SET app.nothing 0");
        }
        return log.substr(log.find(" SET"));
    };
    const std::string hands = log_of(false);
    EXPECT_TRUE(
        hands.starts_with(" SET app.pause 1\n SET wind_speed 12\n SET app.pause 0\n"
                          " SET app.time 0\n SET app.nothing 0\n"))
        << hands;
    const std::string all = log_of(true);
    EXPECT_TRUE(
        all.starts_with(" SET app.frame_rate 60.0\n SET app.time 1.5\n SET app.pause 0\n"
                        " SET app.speed 1\n SET app.pause 1\n SET app.pause 1\n"))
        << all;
}

TEST(LineServer, FiveThousandConnectionsLeaveNoDescriptor) {
    const Served served({.clients = 1000}, kKnobAndLamp);
    served.client().close();
    ASSERT_TRUE(comes_true([&] { return served.server.clients() == 0; }));
    const std::size_t before = open_descriptors();
    for (int i = 0; i < 5000; ++i) {
        RawClient raw(served.server.endpoint());
        ASSERT_TRUE(raw.connected()) << i;
        if (i % 3 != 0) raw.send("SUBSCRIBE\n");
        if (i % 2 == 0) raw.reset();
    }
    EXPECT_TRUE(comes_true([&] { return served.server.clients() == 0; }));
    EXPECT_TRUE(comes_true([&] { return open_descriptors() == before; }));
    RawClient after = served.client();
    EXPECT_EQ(after.ask("PING"), "OK");
}

TEST(LineServer, StopEndsEveryClientAndMayComeTwice) {
    Served served({}, kKnobAndLamp);
    RawClient raw = served.client();
    served.server.stop();
    EXPECT_EQ(raw.line(), "EVT STOP");
    EXPECT_EQ(raw.line(), "");
    served.server.stop();
    RawClient late(served.server.endpoint());
    EXPECT_FALSE(late.connected());
}

TEST(LineServer, StartsAgainOnThePortOfBefore) {
    Endpoint endpoint;
    for (int i = 0; i < 5; ++i) {
        Served served({.listen = {"127.0.0.1", endpoint.port}}, kKnobAndLamp);
        RawClient raw = served.client();
        EXPECT_EQ(raw.ask("PING"), "OK");
        endpoint = served.server.endpoint();
    }
}

}  // namespace
}  // namespace ocean::bridge::test
