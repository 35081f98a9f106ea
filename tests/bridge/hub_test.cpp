// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The hub and the boards that are files: the lines of a script arrive, a recorded take can be read
// with a sea file, and a map may change at run time.
#include "ocean/internal/bridge/hub.hpp"

#include "listening.hpp"
#include "mistakes.hpp"
#include "ocean/internal/bridge/endpoint.hpp"
#include "ocean/internal/bridge/script_sources.hpp"
#include "ocean/seafile.hpp"
#include "refusal.hpp"
#include "temporary_folder.hpp"

namespace ocean::bridge {
namespace {

using namespace std::chrono_literals;
using test::Ear;

/// Waits for so many reports.
void wait_for(Ear& ear, std::size_t count) {
    ASSERT_TRUE(ear.hears([&](const auto& reports) { return reports.size() >= count; }));
}

TEST(Script, LinesAreCheckedOneByOne) {
    const auto script = parse_script("# a\n0.5 board0/a1 128 # up\n\n2 board0/d1 1\r\n", "s");
    ASSERT_EQ(script.size(), 2u);
    EXPECT_EQ(script[1].channel, "board0/d1");
    for (const ocean::test::Mistake& mistake :
         ocean::test::mistakes("bridge/mistakes.toml", "scripts")) {
        ocean::test::expect_refusal(ErrorKind::bad_file, mistake.says,
                                    [&] { parse_script(mistake.text, "s"); });
    }
    EXPECT_THROW(make_dummy_source(parse_script("1 board0/a3 2\n", "s")), Error);
    EXPECT_THROW(make_dummy_source(parse_script("1 board0/a1 256\n", "s")), Error);
}

TEST(DummySource, RestsUntilItIsMoved) {
    Ear ear;
    const auto board = make_dummy_source(parse_script("0.01 board0/a1 7\n", "s"));
    const auto start = Clock::now();
    board->start(ear.listener());
    wait_for(ear, 10);
    EXPECT_GE(Clock::now() - start, 9ms);
    ASSERT_EQ(ear.values().size(), 10u);  // nine inputs at rest, and the line of the script
    EXPECT_EQ(ear.values()[9], "board0/a1 = 7");
    board->put("board0/a2", 30);
    board->put("board0/o1", 1);  // a lamp reports nothing
    wait_for(ear, 11);
    ASSERT_EQ(ear.values().size(), 11u);
    EXPECT_EQ(ear.values()[10], "board0/a2 = 30");
    EXPECT_THROW(board->put("board0/o1", 2), Error);
    EXPECT_THROW(board->put("board0/x1", 0), Error);
    board->stop();
    board->put("board0/a2", 31);
    EXPECT_EQ(ear.values().size(), 11u);
}

TEST(ReplaySource, PlaysARecordingAndHasNoOutputs) {
    Ear ear;
    const auto board = make_replay_source(parse_script("0 midi0/cc1 3\n0.01 midi0/cc1 4\n", "s"));
    EXPECT_EQ(board->channels().size(), 1u);
    board->start(ear.listener());
    wait_for(ear, 2);
    EXPECT_THROW(board->put("midi0/cc1", 1), Error);
}

TEST(DummySource, StopsInTheMiddleOfAScript) {
    Ear ear;
    const auto board = make_dummy_source(parse_script("1000 board0/a1 7\n", "s"));
    board->start(ear.listener());
    board->stop();
    wait_for(ear, 9);
    EXPECT_EQ(ear.values().size(), 9u);
}

TEST(Hub, ARecordingIsATakeOfTheSea) {
    const ocean::test::TemporaryFolder folder;
    Hub hub({.map_text = std::string(kDefaultMap), .take_folder = folder.path()}, {});
    const auto start = Clock::now();
    const auto turn = [&](double raw, Clock::duration at) {
        hub.report({start + at, "board0/a1", raw});
    };
    turn(0, 0s);
    hub.start_recording("storm.take", "test");
    turn(50, 1s);
    turn(100, 2s);
    for (int i = 0; i < 100; ++i) turn(150 + i, 3s + i * 1ms);  // faster than a take holds
    hub.set("app.speed", "2", "test");                          // no part of the sea
    hub.set("patch_size", "400", "test");                       // not live
    hub.stop_recording("", "test");
    const Take take =
        parse_take(ocean::test::read_bytes(folder.file("storm.take")), "storm.take", Parameters());
    ASSERT_GE(take.events.size(), 4u);
    ASSERT_LE(take.events.size(), 10u);
    EXPECT_NEAR(take.events[1].seconds - take.events[0].seconds, 1.0, 1e-6);
    EXPECT_NEAR(std::get<double>(take.events.back().value), 249.0 / 255.0 * 30.0, 1e-4);
    // An existing file is not overwritten.
    hub.start_recording("storm.take", "test");
    hub.stop_recording("", "test");
    EXPECT_TRUE(std::filesystem::exists(folder.file("storm_1.take")));
}

TEST(Hub, TheClientThatShowsTheSeaRecordsIt) {
    const ocean::test::TemporaryFolder folder;
    Hub hub({.take_folder = folder.path()}, {});
    hub.set("app.frame_rate", "60", "127.0.0.1:9");
    hub.start_recording("storm.take", "test");
    hub.stop_recording("", "test");
    hub.start_recording("", "test");
    hub.stop_recording("calm.take", "test");
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
    EXPECT_EQ(
        hub.events(),
        (std::vector<std::string>{
            "RECORD START storm.take by 127.0.0.1:9 in its sea time", "RECORD STOP storm.take",
            "RECORD START - by 127.0.0.1:9 in its sea time", "RECORD STOP calm.take"}));
    hub.client_left("127.0.0.1:9");
    hub.start_recording("", "test");
    hub.finish();
    EXPECT_TRUE(std::filesystem::exists(folder.file("take_1.take")));
}

TEST(Hub, ATakesNameIsNoPath) {
    Hub hub({}, {});
    for (const char* name : {"../x", "/tmp/x", ".x", "a/b", "a b", "a\\b", "x\n"}) {
        EXPECT_THROW(hub.start_recording(name, "test"), Error) << name;
    }
    EXPECT_EQ(hub.values().number(hub.values().find("app.record")), 0.0);
}

TEST(Hub, ABoardThatReturnsMovesNothingAndGetsItsOutputs) {
    const auto board = std::make_shared<test::Board>();
    std::vector<std::unique_ptr<Source>> sources;
    sources.push_back(std::make_unique<test::TestSource>(board));
    Hub hub({.map_text = R"(
[[map]]
from = "board0/a1"
to = "wind_speed"
in = [0, 10]
out = [0, 10]
hysteresis = 0
[[out]]
from = "wind_speed"
to = "board0/dac1"
in = [0, 10]
[[out]]
from = "app.pause"
to = "board1/o1"
out = [0, 1]
)"},
            std::move(sources));
    const auto wind = [&] { return hub.values().number(hub.values().find("wind_speed")); };
    const auto turn = [&](double raw) { hub.report({Clock::now(), "board0/a1", raw}); };
    turn(3);
    turn(4);
    EXPECT_EQ(wind(), 4.0);
    hub.on_board_event({BoardEvent::Kind::lost, "board0", "unplugged"});
    hub.on_board_event({BoardEvent::Kind::connected, "board0", "again"});
    const std::vector<std::pair<std::string, double>> told = {{"board0/dac1", 102.0},
                                                              {"board0/dac1", 102.0}};
    EXPECT_EQ(board->told, told);
    turn(9);  // where the knob was left
    EXPECT_EQ(wind(), 4.0);
    turn(8);
    EXPECT_EQ(wind(), 8.0);
    hub.on_board_event({BoardEvent::Kind::connected, "board1", "another"});
    turn(7);
    EXPECT_EQ(wind(), 7.0);
    EXPECT_EQ(hub.events(),
              (std::vector<std::string>{"board0 LOST: unplugged", "board0 CONNECTED: again",
                                        "board1 CONNECTED: another"}));
}

TEST(Hub, WordsInTheNamesAndFaultsOfBoardsAreNoEvents) {
    // A board whose name or fault has the words of other events holds its button.
    Hub hub({.map_text = R"(
[[map]]
from = "board0/d1"
to = "app.pause"
mode = "momentary"
)"},
            {});
    const auto paused = [&] { return hub.values().number(hub.values().find("app.pause")) == 1.0; };
    for (const double raw : {0.0, 1.0}) hub.report({Clock::now(), "board0/d1", raw});
    ASSERT_TRUE(paused());
    hub.on_board_event({BoardEvent::Kind::connected, "board0 LOST"});
    EXPECT_TRUE(paused());
    hub.on_board_event({BoardEvent::Kind::busy, "board0", "board0 LOST: another program has it"});
    EXPECT_TRUE(paused());
    hub.on_board_event({BoardEvent::Kind::busy, "board0 LOST", "nothing answers"});
    EXPECT_TRUE(paused());
    hub.on_board_event({BoardEvent::Kind::lost, "board0", " CONNECTED: to nothing"});
    EXPECT_FALSE(paused());
    EXPECT_EQ(hub.events(), (std::vector<std::string>{
                                "board0 LOST CONNECTED",
                                "board0 BUSY: board0 LOST: another program has it",
                                "board0 LOST BUSY: nothing answers",
                                "board0 LOST:  CONNECTED: to nothing",
                            }));
}

TEST(Hub, AButtonOfABoardThatIsLostIsLetGo) {
    Hub hub({.map_text = R"(
[[map]]
from = "board0/d1"
to = "app.pause"
mode = "momentary"
[[map]]
from = "board0/d2"
to = "app.record"
mode = "toggle"
)"},
            {});
    const auto value = [&](const char* name) {
        return hub.values().number(hub.values().find(name));
    };
    for (const double raw : {0.0, 1.0}) {
        hub.report({Clock::now(), "board0/d1", raw});
        hub.report({Clock::now(), "board0/d2", raw});
    }
    ASSERT_EQ(value("app.pause"), 1.0);
    hub.on_board_event({BoardEvent::Kind::lost, "board1", "another"});
    EXPECT_EQ(value("app.pause"), 1.0);
    hub.on_board_event({BoardEvent::Kind::lost, "board0", "unplugged"});
    EXPECT_EQ(value("app.pause"), 0.0);
    EXPECT_EQ(value("app.record"), 1.0);  // it was switched, and not held
    hub.on_board_event({BoardEvent::Kind::connected, "board0", "again"});
    hub.report({Clock::now() + 1s, "board0/d1", 1.0});  // it is held
    EXPECT_EQ(value("app.pause"), 0.0);
    hub.report({Clock::now() + 2s, "board0/d1", 0.0});
    hub.report({Clock::now() + 3s, "board0/d1", 1.0});
    EXPECT_EQ(value("app.pause"), 1.0);
}

TEST(Hub, ABoardHasOneName) {
    const std::string device = "[[device]]\nid = \"board0\"\ndriver = \"k8055\"\n";
    std::vector<std::unique_ptr<Source>> dummy;
    dummy.push_back(make_dummy_source());
    EXPECT_THROW(Hub({.map_text = device}, std::move(dummy)), Error);
    EXPECT_THROW(Hub({.map_text = device + device}, {}), Error);
}

TEST(Hub, AMapIsReadAgainWhenItChanges) {
    const ocean::test::TemporaryFolder folder;
    const std::string map = folder.file("map.toml");
    const auto write = [&](const std::string& out) {
        std::ofstream(map) << "[[map]]\nfrom = \"board0/a1\"\nto = \"wind_speed\"\nhysteresis = 0\n"
                           << "in = [0, 10]\nout = " << out << "\n";
        // A clock of the file system may be coarse.
        static auto time = std::filesystem::last_write_time(map);
        std::filesystem::last_write_time(map, time += 1s);
    };
    write("[0, 10]");
    Hub hub({.map = map}, {});
    const auto wind_at = [&](double raw) {
        hub.report({Clock::now(), "board0/a1", raw - 1});
        hub.report({Clock::now(), "board0/a1", raw});
        return hub.values().number(hub.values().find("wind_speed"));
    };
    EXPECT_EQ(wind_at(5), 5.0);
    write("[0, 20]");
    hub.poll_map_file();
    EXPECT_EQ(wind_at(5), 10.0);
    write("[0, 2000]");
    hub.poll_map_file();
    EXPECT_EQ(wind_at(5), 10.0);
    const auto events = hub.events();
    ASSERT_EQ(events.size(), 2u);
    EXPECT_NE(events[1].find("MAP stays as it was"), std::string::npos);
}

TEST(Endpoint, IsHostAndPort) {
    EXPECT_EQ(parse_endpoint("127.0.0.1:80", "x").text(), "127.0.0.1:80");
    EXPECT_EQ(parse_endpoint("[::1]:80", "x").text(), "[::1]:80");
    EXPECT_EQ(parse_endpoint("tablet", "x").port, 4747);
    for (const char* good : {"127.0.0.1", "127.9.9.9", "[::1]", "localhost"}) {
        EXPECT_TRUE(parse_endpoint(good, "x").is_loopback()) << good;
    }
    for (const char* far : {"0.0.0.0", "192.168.1.7", "[::]", "example.org", "128.0.0.1"}) {
        EXPECT_FALSE(parse_endpoint(far, "x").is_loopback()) << far;
    }
    for (const char* bad : {"", ":1", "a:b", "a:65536", "a:-1", "[::1", "[x]:1", "a b", "::1:4"}) {
        EXPECT_THROW(parse_endpoint(bad, "x"), Error) << bad;
    }
}

TEST(Token, IsAWholeSecret) {
    const ocean::test::TemporaryFolder folder;
    const std::string path = folder.file("token");
    std::ofstream(path) << "0123456789abcdef\n";
    std::filesystem::permissions(path, std::filesystem::perms::owner_read);
    const std::string token = read_token(path);
    EXPECT_TRUE(same_token("0123456789abcdef", token));
    for (const char* guess : {"", "0", "0123456789abcdeg", "0123456789abcdef0123456789abcdef"}) {
        EXPECT_FALSE(same_token(guess, token)) << guess;
    }
    EXPECT_FALSE(same_token("", ""));
    std::filesystem::permissions(path, std::filesystem::perms(0644));
    EXPECT_THROW(read_token(path), Error);
}

}  // namespace
}  // namespace ocean::bridge
