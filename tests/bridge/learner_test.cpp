// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The movement of a control becomes the map that fits it, and no other; and every map that is
// printed is one.
#include "ocean/internal/bridge/learner.hpp"

#include "midi_messages.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/bridge/control_map_file.hpp"
#include "scripted.hpp"

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
        map.pop_back();
        return map;
    }

    ValueTable values_;
    Learner learner_;
    MidiParser parser_;
    MidiJoiner joiner_;
    Clock::time_point now_{1h};
};

class HandScript : public testing::TestWithParam<test::Script> {};

TEST_P(HandScript, TeachesWhatItSays) {
    std::optional<Hand> hand(std::in_place);
    std::optional<Channel> known;
    for (const auto& [line, words, gives] : GetParam().steps) {
        SCOPED_TRACE(line);
        std::vector<double> values;
        for (std::size_t i = words[0] == "plays" ? 1 : 2; i < words.size(); ++i) {
            values.push_back(std::stod(words[i]));
        }
        if (words[0] == "anew") {
            hand.emplace();
        } else if (words[0] == "known") {
            known = Channel{words[1], values[0], values[1], false};
        } else if (words[0] == "says") {
            hand->says(words[1], values, known && known->name == words[1] ? &*known : nullptr);
        } else if (words[0] == "plays") {
            hand->plays({values.begin(), values.end()});
        } else {
            const std::vector<std::string> lessons = hand->rests();
            ASSERT_EQ(lessons.size(), gives->empty() ? 0u : 1u);
            if (lessons.empty()) continue;
            ocean::test::expect_sentence(lessons[0], gives->substr(1));
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Of, HandScript, testing::ValuesIn(test::scripts_of("learner.toml")),
                         test::name_of_script);

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
