// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The movement of a control becomes the map that fits it, and no other; and every map that is
// printed is one.
#include "ocean/internal/bridge/learner.hpp"

#include <gtest/gtest.h>

#include "midi_messages.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/bridge/control_map_file.hpp"

namespace ocean::bridge {
namespace {

using namespace std::chrono_literals;
using Bytes = std::vector<std::uint8_t>;

/// A controller that a hand moves, one message each 20 ms.
class Hand {
  public:
    explicit Hand(const std::string& to = "") : learner_(values_, to) {}

    Hand& says(const std::string& channel, const std::vector<double>& values,
               const Channel* known = nullptr) {
        for (const double value : values) {
            learner_.report({now_, channel, value}, known);
            now_ += 20ms;
        }
        return *this;
    }
    /// Messages of 3 bytes, all at once, as a source reports them.
    Hand& plays(const Bytes& bytes) {
        const auto hear = [&](const std::vector<MidiReport>& reports) {
            for (const MidiReport& report : reports) {
                constexpr std::array kLetters = {"cc", "n", "pb", "pair", "nrpn", "rpn"};
                learner_.report(
                    {now_,
                     std::string("m/") + kLetters[static_cast<std::size_t>(report.kind)] +
                         std::to_string(report.number),
                     static_cast<double>(report.value), true},
                    nullptr);
            }
        };
        for (const MidiReport& report : parser_.feed(bytes)) {
            hear({report});
            hear(joiner_.take(report, now_));
        }
        now_ += 20ms;
        hear(joiner_.advance(now_));
        return *this;
    }
    /// The lessons once all rests; of a map the keys in one line.
    std::vector<std::string> rests() {
        EXPECT_TRUE(learner_.next().has_value());
        EXPECT_TRUE(learner_.advance(*learner_.next() - 1ms).empty());
        now_ += 1s;
        std::vector<std::string> lessons;
        for (const Lesson& lesson : learner_.advance(now_)) {
            lessons.push_back(lesson.is_map ? checked(lesson.text) : lesson.text);
        }
        EXPECT_FALSE(learner_.next().has_value());
        return lessons;
    }

  private:
    std::string checked(std::string map) const {
        const ControlMapFile file = parse_control_map(map, "learnt.toml", values_);
        EXPECT_EQ(file.maps.size(), 1u);
        std::ranges::replace(map, '\n', ' ');
        return map;
    }

    ValueTable values_;
    Learner learner_;
    MidiParser parser_;
    MidiJoiner joiner_;
    Clock::time_point now_{1h};
};

using Lessons = std::vector<std::string>;

std::string map_of(const std::string& channel, const std::string& more) {
    return "[[map]] from = \"" + channel + "\" to = \"wind_speed\" " + more + "out = [2, 35] ";
}
const std::string kFader = "in = [0, 127] hysteresis = 0 takeover = \"pickup\" ";
const std::string kWide = "in = [0, 16383] hysteresis = 0 takeover = \"pickup\" ";
const std::string kCoarse = "in = [0, 16256] hysteresis = 0 takeover = \"pickup\" ";
std::string turned(const std::string& code) {
    return map_of("m/cc16", "mode = \"relative\" code = \"" + code + "\" step = 0.33 ");
}

TEST(Learner, TellsEndlessKnobsByTheirBytes) {
    EXPECT_EQ(Hand().says("m/cc16", {1, 1, 2, 1, 127, 127, 126}).rests(),
              Lessons{turned("twos_complement")});
    EXPECT_EQ(Hand().says("m/cc16", {65, 65, 66, 65, 63, 63, 62}).rests(),
              Lessons{turned("binary_offset")});
    EXPECT_EQ(Hand().says("m/cc16", {1, 1, 2, 1, 65, 65, 66}).rests(),
              Lessons{turned("signed_bit")});
}

/// 1 may be +1 of two codes, 65 may be +1 and -1: one way alone does not tell.
TEST(Learner, AsksForBothWaysBeforeItNamesACode) {
    for (const double one : {1.0, 65.0, 127.0, 63.0}) {
        Hand hand;
        const Lessons hint = hand.says("m/cc16", {one, one, one}).rests();
        ASSERT_EQ(hint.size(), 1u);
        EXPECT_NE(hint[0].find("move it further, an endless knob in both directions"),
                  std::string::npos);
        EXPECT_EQ(hand.says("m/cc16", {one}).rests(), Lessons{}) << "it is hinted at once";
    }
    Hand hand;
    hand.says("m/cc16", {65, 65, 65}).rests();
    EXPECT_EQ(hand.says("m/cc16", {1, 1}).rests(), Lessons{turned("signed_bit")});
}

TEST(Learner, TellsFadersFromEndlessKnobs) {
    const Lessons fader = {map_of("m/cc16", kFader)};
    EXPECT_EQ(Hand().says("m/cc16", {10, 20, 30}).rests(), fader);
    EXPECT_EQ(Hand().says("m/cc16", {127, 120, 100}).rests(), fader);
    EXPECT_EQ(Hand().says("m/cc16", {0, 1, 2, 3, 60}).rests(), fader);
    // Around the middle, and in steps that jump over it.
    EXPECT_EQ(Hand().says("m/cc16", {50, 58, 66, 74, 82}).rests(), fader);
    Hand slow;
    EXPECT_EQ(slow.says("m/cc16", {1, 2, 3, 4, 5}).rests().size(), 1u);  // a hint
    EXPECT_EQ(slow.says("m/cc16", {6, 10, 20}).rests(), fader);
}

TEST(Learner, TellsValuesOfFourteenBits) {
    EXPECT_EQ(Hand().plays({0xB0, 7, 64, 39, 32}).plays({7, 65, 39, 1}).rests(),
              Lessons{map_of("m/pair7", kWide)});
    Hand slow;
    EXPECT_EQ(slow.plays({0xB0, 7, 64, 39, 32}).plays({39, 33}).plays({39, 34}).rests().size(), 1u);
    EXPECT_EQ(slow.plays({7, 65, 39, 0}).plays({7, 66, 39, 0}).plays({7, 67, 39, 9}).rests(),
              Lessons{map_of("m/pair7", kWide)});
    // A slider on cc0 and a button on cc32, as a nanoKONTROL2 has them, are no pair.
    Hand nano;
    EXPECT_EQ(
        nano.plays({0xB0, 32, 127}).plays({32, 0}).rests(),
        Lessons{"[[map]] from = \"m/cc32\" to = \"app.pause\" mode = \"toggle\" out = [0, 1] "});
    EXPECT_EQ(nano.plays({0, 10}).plays({0, 20}).plays({0, 40}).rests(),
              Lessons{map_of("m/cc0", kFader)});
    // With and without its fine byte.
    Hand nrpn;
    EXPECT_EQ(
        nrpn.plays({0xB0, 99, 1, 98, 8, 6, 10, 38, 0}).plays({99, 1, 98, 8, 6, 80, 38, 16}).rests(),
        Lessons{map_of("m/nrpn136", kWide)});
    EXPECT_EQ(nrpn.plays({99, 1, 98, 9, 6, 10}).plays({6, 80}).rests(),
              Lessons{map_of("m/nrpn137", kCoarse)});
    EXPECT_EQ(nrpn.plays({101, 0, 100, 0, 6, 10}).plays({6, 80}).rests(),
              Lessons{map_of("m/rpn0", kCoarse)});
    EXPECT_EQ(Hand().says("m/pb1", {8192, 10000, 16383}).rests(), Lessons{map_of("m/pb1", kWide)});
}

TEST(Learner, TellsButtons) {
    const auto toggle = [](const std::string& channel) {
        return Lessons{"[[map]] from = \"" + channel +
                       "\" to = \"app.pause\" mode = \"toggle\" out = [0, 1] "};
    };
    EXPECT_EQ(Hand().says("m/n36", {1}).rests(), toggle("m/n36"));
    EXPECT_EQ(Hand().says("m/cc48", {127, 0, 127, 0}).rests(), toggle("m/cc48"));
    EXPECT_EQ(Hand().says("board0/d1", {0, 1, 0}).rests(), toggle("board0/d1"));
}

/// A board says where its controls are, again and again, and its inputs are never quite still.
TEST(Learner, TakesABoardsPlaceAndNoiseForNoMove) {
    const Channel knob{"ino/a0", 0.0, 1023.0, false};
    Hand hand;
    hand.says("ino/a0", {500, 501, 499, 500, 498, 512}, &knob);
    hand.says("ino/d2", {1, 1, 1});
    hand.says("ino/a0", {600, 700}, &knob);
    EXPECT_EQ(hand.rests(), Lessons{map_of("ino/a0", "in = [0, 1023] ")});
    hand.says("ino/a0", {701, 699, 700}, &knob);
    hand.says("ino/a0", {400}, &knob);  // the same control again says nothing new
    EXPECT_EQ(hand.rests(), Lessons{});
    hand.says("board0/c1", {65535, 0});
    EXPECT_EQ(hand.rests(),
              Lessons{map_of("board0/c1", "mode = \"increment\" in = [0, 65535] step = 0.33 ")});
}

/// For each number of the table: what is printed is a map.
TEST(Learner, PrintsAMapForEveryNumber) {
    const ValueTable values;
    std::size_t numbers = 0;
    for (std::size_t i = 0; i < values.entries().size(); ++i) {
        const std::string& name = values[i].name;
        if (!values.is_number(i)) {
            EXPECT_THROW(Learner(values, name), Error) << name;
            continue;
        }
        ++numbers;
        Hand hand(name);
        EXPECT_EQ(hand.says("m/cc1", {10, 50, 90}).rests().size(), 1u) << name;
        EXPECT_EQ(hand.says("m/cc2", {1, 1, 1, 127, 127, 127}).rests().size(), 1u) << name;
        EXPECT_EQ(hand.says("m/n3", {1, 0}).rests().size(), 1u) << name;
        EXPECT_EQ(hand.says("board0/c1", {1, 2}).rests().size(), 1u) << name;
    }
    EXPECT_GT(numbers, 20u);
    EXPECT_THROW(Learner(values, "wind_sped"), Error);
}

}  // namespace
}  // namespace ocean::bridge
