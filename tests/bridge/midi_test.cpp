// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// MIDI: bytes of the MIDI 1.0 specification into reports, wherever they are cut; a controller that
// comes and goes on ports that the test stands in for, and on those of ALSA where there is one.
#include <atomic>
#include <thread>

#include "listening.hpp"
#include "midi_messages.hpp"
#include "midi_ports.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/bridge/midi_source.hpp"
#include "scripted.hpp"
#ifdef OCEAN_HAVE_RTMIDI
#include <RtMidi.h>
#endif

namespace ocean::bridge {
namespace {

using namespace std::chrono_literals;
using test::Ear;
using Bytes = std::vector<std::uint8_t>;

std::vector<MidiReport> parse_midi(const Bytes& bytes) {
    return MidiParser().feed(bytes);
}

TEST(MidiParser, ItDoesNotMatterWhereAStreamIsCut) {
    const Bytes stream = {0xB0, 7,    100,  8,    101,  0xF8, 0x90, 60,   64, 60,   0, 0xF0,
                          1,    0xF7, 0xE0, 0x01, 0x40, 0x02, 0x41, 0xC0, 9,  0xB3, 1, 2};
    const std::vector<MidiReport> whole = parse_midi(stream);
    EXPECT_EQ(whole.size(), 7u);
    for (std::size_t cut = 0; cut <= stream.size(); ++cut) {
        MidiParser parser;
        std::vector<MidiReport> reports = parser.feed(std::span(stream).first(cut));
        const std::vector<MidiReport> rest = parser.feed(std::span(stream).subspan(cut));
        reports.insert(reports.end(), rest.begin(), rest.end());
        EXPECT_EQ(reports, whole) << cut;
    }
}

/// " 2:cc7=100" of each report, without the number of the first MIDI channel.
std::string text_of(const std::vector<MidiReport>& reports) {
    constexpr std::array kNames = {"cc", "n", "pb", "pair", "nrpn", "rpn"};
    std::string text;
    for (const MidiReport& report : reports) {
        text += " " + (report.channel > 1 ? std::to_string(report.channel) + ":" : std::string()) +
                kNames[static_cast<std::size_t>(report.kind)] + std::to_string(report.number) +
                "=" + std::to_string(report.value);
    }
    return text;
}

class MidiScript : public testing::TestWithParam<test::Script> {};

TEST_P(MidiScript, SaysWhatItSays) {
    MidiParser parser;
    MidiJoiner joiner;
    Clock::time_point now{1h};
    for (const auto& [line, words, gives] : GetParam().steps) {
        SCOPED_TRACE(line);
        Bytes bytes;
        for (std::size_t i = 1; i < words.size(); ++i) {
            bytes.push_back(static_cast<std::uint8_t>(std::stoi(words[i], nullptr, 0)));
        }
        std::string given;
        if (words[0] == "rests") {
            EXPECT_FALSE(joiner.next());
            continue;
        }
        if (words[0] == "parse") given = text_of(parse_midi(bytes));
        if (words[0] == "join") {
            for (const MidiReport& report : parser.feed(bytes)) {
                given += text_of(joiner.take(report, now));
            }
        }
        if (words[0] == "pass") given = text_of(joiner.advance(now += bytes[0] * 1ms));
        EXPECT_EQ(given, gives);
    }
}

INSTANTIATE_TEST_SUITE_P(Of, MidiScript, testing::ValuesIn(test::scripts_of("midi.toml")),
                         test::name_of_script);

/// A system whose ports the test plugs.
struct System {
    std::mutex mutex;
    std::vector<std::string> names;
    bool works = true;
    int looks = 0;
    int plugs = 0;  // of whatever is there
    int opened_at = 0;
    std::string open;
    MidiPorts::Receiver receiver;
    std::vector<Bytes> sent;

    void plug(const std::string& name) {
        const std::lock_guard lock(mutex);
        names.push_back(name);
        ++plugs;
    }
    void unplug() {
        const std::lock_guard lock(mutex);
        names.clear();
    }
    void replug() {
        const std::lock_guard lock(mutex);
        ++plugs;
    }
    void work(bool whether) {
        const std::lock_guard lock(mutex);
        works = whether;
    }
    void play(const Bytes& bytes) {
        const std::lock_guard lock(mutex);
        if (receiver) receiver(bytes);
    }
    int how_often_looked() {
        const std::lock_guard lock(mutex);
        return looks;
    }
    std::vector<Bytes> what_was_sent() {
        const std::lock_guard lock(mutex);
        return sent;
    }
};

class TestPorts : public MidiPorts {
  public:
    explicit TestPorts(std::shared_ptr<System> system) : system_(std::move(system)) {}
    std::vector<std::string> inputs() override {
        const std::lock_guard lock(system_->mutex);
        ++system_->looks;
        if (!system_->works) throw Error(ErrorKind::not_found, "no ALSA sequencer");
        return system_->names;
    }
    bool open(const std::string& name, Receiver receiver) override {
        const std::lock_guard lock(system_->mutex);
        system_->open = name;
        system_->opened_at = system_->plugs;
        system_->receiver = std::move(receiver);
        return true;
    }
    bool is_still_connected() override {
        const std::lock_guard lock(system_->mutex);
        return std::ranges::find(system_->names, system_->open) != system_->names.end() &&
               system_->opened_at == system_->plugs;
    }
    void close() override {
        const std::lock_guard lock(system_->mutex);
        system_->receiver = nullptr;
        system_->open.clear();
    }
    void send(std::span<const std::uint8_t> bytes) override {
        const std::lock_guard lock(system_->mutex);
        system_->sent.emplace_back(bytes.begin(), bytes.end());
    }

  private:
    std::shared_ptr<System> system_;
};

class MidiController : public testing::Test {
  protected:
    void begin(const MidiDevice& device) {
        source = make_midi_source("m", device, std::make_unique<TestPorts>(system), 1ms);
        source->start(ear.listener());
    }
    bool sends(const std::vector<Bytes>& expected) const {
        for (int i = 0; i < test::kPatience; ++i) {
            if (system->what_was_sent() == expected) return true;
            std::this_thread::sleep_for(1ms);
        }
        return false;
    }

    Ear ear;
    std::shared_ptr<System> system = std::make_shared<System>();
    std::unique_ptr<Source> source;
};

TEST_F(MidiController, ReportsEachMessageAndThatAHandDidIt) {
    system->plug("nanoKONTROL2:nanoKONTROL2 MIDI 1 20:0");
    begin({});
    ASSERT_TRUE(ear.hears_event("m CONNECTED: nanoKONTROL2:nanoKONTROL2 MIDI 1 20:0"));
    system->play({0xB0, 7, 100, 7, 100, 7, 101, 0x95, 36, 90, 36, 0, 0xE0, 0, 64});
    ASSERT_TRUE(ear.hears([](const auto& reports) {
        return reports.size() == 6 && std::ranges::all_of(reports, &Report::moved);
    }));
    EXPECT_EQ(ear.values(), (std::vector<std::string>{"m/cc7 = 100", "m/cc7 = 100", "m/cc7 = 101",
                                                      "m/n36 = 1", "m/n36 = 0", "m/pb1 = 8192"}));
    for (const char* name : {"m/cc0", "m/cc127", "m/n0", "m/n127", "m/pb1", "m/pair0", "m/pair31",
                             "m/led0", "m/led127", "m/lamp0", "m/lamp127"}) {
        EXPECT_NE(find_channel(source->channels(), name), nullptr) << name;
        EXPECT_TRUE(is_channel_name(name));
    }
}

/// The coarse byte of a selected number without its fine one is reported when that is late, by the
/// source's own thread.
TEST_F(MidiController, ReportsValuesOfFourteenBits) {
    system->plug("x 20:0");
    begin({});
    ASSERT_TRUE(ear.hears_events(1));
    system->play({0xB0, 7, 64, 39, 32});
    system->play({99, 1, 98, 8, 6, 80});
    ASSERT_TRUE(ear.hears([](const auto& reports) { return reports.size() == 7; }));
    EXPECT_EQ(ear.values(),
              (std::vector<std::string>{"m/cc7 = 64", "m/cc39 = 32", "m/pair7 = 8224", "m/cc99 = 1",
                                        "m/cc98 = 8", "m/cc6 = 80", "m/nrpn136 = 10240"}));
}

TEST_F(MidiController, OneOfItsChannelsAloneCounts) {
    system->plug("x 20:0");
    begin({"", 3});
    ASSERT_TRUE(ear.hears_events(1));
    system->play({0xB0, 7, 1, 0xB2, 7, 2, 0xB3, 7, 3});
    EXPECT_EQ(ear.values(), (std::vector<std::string>{"m/cc7 = 2"}));
    source->put("m/led5", 127);
    EXPECT_TRUE(sends({{0xB2, 5, 127}}));
}

TEST_F(MidiController, ItsPortIsFoundByAPartOfTheName) {
    system->plug("Midi Through:Midi Through Port-0 14:0");
    system->plug("ocean-bridge:ocean-bridge 130:0");
    system->plug("X-TOUCH MINI:X-TOUCH MINI MIDI 1 24:0");
    system->plug("nanoKONTROL2:nanoKONTROL2 MIDI 1 20:0");
    begin({"NANOkontrol", 0});
    EXPECT_TRUE(ear.hears_event("m CONNECTED: nanoKONTROL2:nanoKONTROL2 MIDI 1 20:0"));
    source->stop();
    begin({"through", 0});
    EXPECT_TRUE(ear.hears_event("m CONNECTED: Midi Through:Midi Through Port-0 14:0"));
    source->stop();
    begin({});
    EXPECT_TRUE(ear.hears_event("m CONNECTED: X-TOUCH MINI:X-TOUCH MINI MIDI 1 24:0"));
}

TEST_F(MidiController, LampsAreLitAgainAndPutOutAtTheEnd) {
    begin({});
    source->put("m/led48", 127);
    source->put("m/lamp60", 5);
    system->plug("x 20:0");
    ASSERT_TRUE(ear.hears_events(1));
    const std::vector<Bytes> lit = {{0xB0, 48, 127}, {0x90, 60, 5}};
    ASSERT_TRUE(sends(lit));
    system->unplug();
    ASSERT_TRUE(ear.hears_event("m LOST"));
    source->put("m/lamp60", 0);
    system->plug("x 20:0");
    ASSERT_TRUE(sends({lit[0], lit[1], lit[0], {0x90, 60, 0}}));
    source->stop();
    EXPECT_EQ(system->what_was_sent().back(), (Bytes{0xB0, 48, 0}));
    EXPECT_EQ(system->what_was_sent().size(), 5u);
}

TEST_F(MidiController, WhatItHasBegunIsForgottenWhenItGoes) {
    system->plug("x 20:0");
    begin({});
    ASSERT_TRUE(ear.hears_events(1));
    system->play({0xB0, 7, 1, 8});
    system->replug();  // between two looks
    ASSERT_TRUE(ear.hears_events(3));
    system->play({9, 0xB0, 39, 1});
    EXPECT_EQ(ear.values(), (std::vector<std::string>{"m/cc7 = 1", "m/cc39 = 1"}));
    EXPECT_EQ(ear.events(),
              (std::vector<std::string>{"m CONNECTED: x 20:0", "m LOST", "m CONNECTED: x 20:0"}));
}

TEST_F(MidiController, ASystemWithoutMidiIsSaidOnceAndLookedAtAgain) {
    system->work(false);
    system->plug("x 20:0");
    begin({});
    ASSERT_TRUE(ear.hears_event("m BUSY: no ALSA sequencer"));
    const int before = system->how_often_looked();
    for (int i = 0; i < test::kPatience && system->how_often_looked() < before + 3; ++i) {
        std::this_thread::sleep_for(1ms);
    }
    EXPECT_GE(system->how_often_looked(), before + 3);
    EXPECT_EQ(ear.events().size(), 1u);
    system->work(true);
    EXPECT_TRUE(ear.hears_event("m CONNECTED: x 20:0"));
}

TEST_F(MidiController, AHundredPlugs) {
    begin({});
    EXPECT_TRUE(source->channels().empty());
    for (int i = 0; i < 100; ++i) {
        system->plug("x 20:0");
        ASSERT_TRUE(ear.hears_event("m CONNECTED: x 20:0"));
        system->play({0xB0, 7, 1});
        ASSERT_TRUE(ear.hears([](const auto& reports) { return reports.size() == 1; }));
        system->unplug();
        ASSERT_TRUE(ear.hears_event("m LOST"));
        ASSERT_TRUE(source->channels().empty());
        ASSERT_EQ(ear.events().size(), 2u);
        ear.forget();
    }
}

TEST_F(MidiController, OnlyOutputsAreToldAndOnlyWhatTheyTake) {
    begin({});
    EXPECT_THROW(source->put("m/cc7", 1), Error);
    EXPECT_THROW(source->put("m/led128", 1), Error);
    EXPECT_THROW(source->put("m/led7", 128), Error);
    EXPECT_THROW(source->put("m/led7", std::nan("")), Error);
    source->stop();
    source->stop();
    source->put("m/led7", 1);
}

#ifdef OCEAN_HAVE_RTMIDI
bool has_sequencer() {
    return ::access("/dev/snd/seq", R_OK | W_OK) == 0;
}

TEST(MidiOfThisSystem, AMachineWithoutItIsSaidToBeAndNothingIsPrinted) {
    Ear ear;
    const auto source = make_midi_source("m", MidiDevice{"no controller has this name", 0});
    testing::internal::CaptureStderr();
    source->start(ear.listener());
    if (!has_sequencer()) {
        EXPECT_TRUE(ear.hears_events(1));
        EXPECT_TRUE(ear.events().front().starts_with("m BUSY: no ALSA sequencer: /dev/snd/seq: "));
    }
    source->stop();
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

/// Through RtMidi and ALSA, from a port of this process.
TEST(MidiOfThisSystem, AControllerComesPlaysAndGoes) {
    if (!has_sequencer()) GTEST_SKIP() << "this machine has no ALSA sequencer";
    const std::string name = "Pads " + std::to_string(::getpid());
    Ear ear;
    const auto source = make_midi_source("m", MidiDevice{name, 0});
    source->start(ear.listener());
    for (int plug = 0; plug < 2; ++plug) {
        auto controller = std::make_unique<RtMidiOut>(RtMidi::LINUX_ALSA, name);
        controller->openVirtualPort("1");
        ASSERT_TRUE(ear.hears_events(1));
        EXPECT_TRUE(ear.events().front().starts_with("m CONNECTED: " + name + ":1 "));
        source->put("m/led1", 1);  // it has no input: nobody gets it
        for (const int value : {5, 5, 6}) {
            const MidiMessage message = control_change(3, 7, value);
            controller->sendMessage(message.data(), message.size());
        }
        ASSERT_TRUE(ear.hears([](const auto& reports) { return reports.size() == 3; }));
        EXPECT_EQ(ear.values(), (std::vector<std::string>{"m/cc7 = 5", "m/cc7 = 5", "m/cc7 = 6"}));
        controller.reset();
        ASSERT_TRUE(ear.hears_event("m LOST"));
        ear.forget();
    }
}
#endif

}  // namespace
}  // namespace ocean::bridge
