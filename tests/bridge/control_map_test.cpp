// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// From a knob to a value: ranges, curves, noise, smoothing, who holds the value; and a map that is
// wrong says where.
#include "ocean/internal/bridge/control_map.hpp"

#include <tuple>

#include "mistakes.hpp"
#include "refusal.hpp"
#include "scripted.hpp"

namespace ocean::bridge {
namespace {

using namespace std::chrono_literals;

/// A map, a table and a clock that the test moves.
class Desk {
  public:
    explicit Desk(const std::string& map)
        : map_(parse_control_map(map, "test.toml", values_), values_) {}

    /// How many values were set.
    std::size_t turn(double raw, const std::string& channel = "board0/a1", bool moved = false) {
        return take(map_.report({now_, channel, raw, moved}, values_));
    }
    void plug(const std::string& board = "board0") { map_.board_connected(board); }
    std::size_t pass(Clock::duration time, Clock::duration step = 1ms) {
        std::size_t count = 0;
        for (const auto end = now_ + time; now_ < end;) {
            now_ += step;
            if (map_.next() && *map_.next() <= now_) {
                count += take(map_.advance(now_, values_));
            }
        }
        return count;
    }
    void write(const std::string& name, const std::string& value) {
        values_.set(values_.find(name), value, "somebody");
    }
    double value(const std::string& name = "wind_speed") const {
        return values_.number(values_.find(name));
    }
    bool still() const { return !map_.next(); }
    std::vector<OutputValue> changed_outputs() { return map_.changed_outputs(values_); }

  private:
    std::size_t take(const std::vector<Setting>& settings) {
        for (const Setting& setting : settings) {
            values_.set(setting.entry, std::to_string(setting.value), setting.writer);
        }
        return settings.size();
    }

    ValueTable values_;
    ControlMap map_;
    Clock::time_point now_{1h};
};

std::string knob(const std::string& more) {
    return "[[map]]\nfrom = \"board0/a1\"\nto = \"wind_speed\"\nout = [0, 30]\n" + more;
}

class DeskScript : public testing::TestWithParam<test::Script> {};

TEST_P(DeskScript, SetsWhatItSays) {
    Desk desk(GetParam().map);
    for (const auto& [line, words, gives] : GetParam().steps) {
        SCOPED_TRACE(line);
        std::size_t settings = 0;
        if (words[0] == "set") {
            desk.write(words[1], words[2]);
        } else if (words[0] == "plug") {
            desk.plug(words[1]);
        } else if (words[0] == "pass") {
            settings = desk.pass(std::stoi(words[1]) * 1ms);
        } else {
            const bool hand = words[0] == "hand";
            settings = desk.turn(std::stod(words.back()), words[hand ? 1 : 0], hand);
        }
        if (!gives) continue;
        std::istringstream given(*gives);
        std::string name;
        double value = 0.0;
        if (given >> name >> value) {
            EXPECT_NEAR(desk.value(name), value, 1e-6);
        } else {
            EXPECT_EQ(name, "nothing");
            EXPECT_EQ(settings, 0u);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Of, DeskScript, testing::ValuesIn(test::scripts_of("desk.toml")),
                         test::name_of_script);

TEST(ControlMap, EachCurveRisesFromEndToEnd) {
    for (const Curve curve :
         {Curve::linear, Curve::smoothstep, Curve::exp, Curve::log, Curve::gamma}) {
        EXPECT_EQ(curved(curve, 2.2, 0.0), 0.0);
        EXPECT_NEAR(curved(curve, 2.2, 1.0), 1.0, 1e-15);
        for (int i = 0; i < 100; ++i) {
            EXPECT_LT(curved(curve, 2.2, i / 100.0), curved(curve, 2.2, (i + 1) / 100.0));
        }
    }
    EXPECT_NEAR(curved(Curve::exp, 1, 0.5), 1.0 / 11.0, 1e-12);  // a decade of two
    EXPECT_NEAR(curved(Curve::log, 1, curved(Curve::exp, 1, 0.3)), 0.3, 1e-12);
}

/// Wherever the knob rests, and after it was moved there.
TEST(ControlMap, NoiseOfOneAtRestIsNoEventInAMinute) {
    std::mt19937 random(7);
    std::uniform_int_distribution<int> noise(-1, 1);
    for (int place = 0; place <= 255; place += 15) {
        Desk desk(knob(""));
        const auto rest = [&] {
            std::size_t events = 0;
            for (int report = 0; report < 6000; ++report) {
                events += desk.turn(std::clamp(place + noise(random), 0, 255));
                events += desk.pass(10ms, 10ms);
            }
            return events;
        };
        EXPECT_EQ(rest(), 0u) << place;
        desk.turn(place < 128 ? 255 : 0);
        desk.pass(1s);
        desk.turn(place);
        for (int report = 0; report < 30; ++report) {
            desk.turn(std::clamp(place + noise(random), 0, 255));
            desk.pass(10ms, 10ms);
        }
        EXPECT_EQ(rest(), 0u) << "after a move to " << place;
    }
}

TEST(ControlMap, AMovedKnobEndsExactlyWhereTheHandLeftIt) {
    Desk desk(knob(""));
    desk.turn(0);
    for (int raw = 1; raw <= 200; ++raw) {
        desk.turn(raw);
        desk.pass(10ms, 10ms);
    }
    EXPECT_NEAR(desk.value(), 30.0 * 200 / 255, 1e-4);
}

/// y(t) = v + (y0 - v) exp(-t / tau), however often the board reports.
TEST(ControlMap, SmoothingIsByTimeNotByReports) {
    for (const auto step : {1ms, 7ms, 40ms}) {
        Desk desk(knob("smooth_ms = 100\nin = [0, 100]\nhysteresis = 0\n"));
        desk.turn(0);
        desk.pass(1s);
        desk.turn(100);
        EXPECT_FALSE(desk.still());
        desk.pass(280ms, step);
        desk.turn(100);  // says nothing new
        EXPECT_NEAR(desk.value(), 30.0 * (1.0 - std::exp(-2.8)), 0.6) << step.count();
        desk.pass(2s, step);
        EXPECT_EQ(desk.value(), 30.0);
        EXPECT_TRUE(desk.still());
    }
}

/// The bytes that endless knobs send, as their makers' manuals and the hosts that take them have
/// it.
TEST(ControlMap, ABytesStepsByItsCode) {
    struct Row {
        int byte, twos_complement, binary_offset, signed_bit;
    };
    for (const Row& row : {Row{0x00, 0, -64, 0}, Row{0x01, 1, -63, 1}, Row{0x02, 2, -62, 2},
                           Row{0x3F, 63, -1, 63}, Row{0x40, -64, 0, 0}, Row{0x41, -63, 1, -1},
                           Row{0x42, -62, 2, -2}, Row{0x7E, -2, 62, -62}, Row{0x7F, -1, 63, -63}}) {
        EXPECT_EQ(relative_steps(RelativeCode::twos_complement, row.byte), row.twos_complement);
        EXPECT_EQ(relative_steps(RelativeCode::binary_offset, row.byte), row.binary_offset);
        EXPECT_EQ(relative_steps(RelativeCode::signed_bit, row.byte), row.signed_bit);
    }
    for (const double no_byte : {-1.0, 128.0, 1e9, std::nan("")}) {
        EXPECT_EQ(relative_steps(RelativeCode::twos_complement, no_byte), 0);
    }
}

/// A step is a hundredth of `out`, from what the value is.
TEST(ControlMap, AnEndlessKnobStepsOnFromTheValue) {
    for (const auto& [code, up, two_up, down] : {std::tuple("twos_complement", 0x01, 0x02, 0x7F),
                                                 std::tuple("binary_offset", 0x41, 0x42, 0x3F),
                                                 std::tuple("signed_bit", 0x01, 0x02, 0x41)}) {
        Desk desk(
            "[[map]]\nfrom = \"m/cc16\"\nto = \"wind_speed\"\nmode = \"relative\"\nout = [0, "
            "30]\n" +
            ("code = \"" + std::string(code)) + "\"\n");
        desk.write("wind_speed", "12");
        const auto turn = [&](int byte) {
            desk.turn(byte, "m/cc16", true);
            return desk.value();
        };
        EXPECT_NEAR(turn(up), 12.3, 1e-12) << code;  // the first byte counts
        EXPECT_NEAR(turn(up), 12.6, 1e-12) << code;  // and so does the same once more
        EXPECT_NEAR(turn(two_up), 13.2, 1e-12) << code;
        EXPECT_NEAR(turn(down), 12.9, 1e-12) << code;
        desk.write("wind_speed", "20");  // another hand
        EXPECT_NEAR(turn(down), 19.7, 1e-12) << code;
        desk.plug("m");
        EXPECT_NEAR(turn(down), 19.4, 1e-12) << code;
    }
}

/// Without `in` a channel of MIDI has the range that its kind has.
TEST(ControlMap, AChannelOfMidiIsAsWideAsItsKind) {
    for (const auto& [channel, highest] :
         {std::pair("m/pair7", 16383.0), std::pair("m/nrpn136", 16383.0),
          std::pair("m/rpn0", 16383.0), std::pair("m/pb1", 16383.0), std::pair("m/cc7", 127.0),
          std::pair("board0/a1", 255.0)}) {
        Desk desk("[[map]]\nfrom = \"" + std::string(channel) +
                  "\"\nto = \"wind_speed\"\nout = [0, 30]\nhysteresis = 0\n");
        desk.turn(0, channel, true);
        desk.turn(highest / 3.0, channel, true);
        EXPECT_NEAR(desk.value(), 10.0, 1e-4) << channel;
        desk.turn(highest, channel, true);
        EXPECT_EQ(desk.value(), 30.0) << channel;
    }
}

TEST(ControlMap, OutputsGetEachChangeOnce) {
    Desk desk(
        "[[out]]\nfrom = \"app.frame_rate\"\nto = \"board0/dac1\"\nin = [0, 120]\nout = [0, "
        "255]\n");
    EXPECT_EQ(desk.changed_outputs().size(), 1u);
    EXPECT_TRUE(desk.changed_outputs().empty());
    desk.write("app.frame_rate", "60");
    const std::vector<OutputValue> outputs = desk.changed_outputs();
    ASSERT_EQ(outputs.size(), 1u);
    EXPECT_EQ(outputs[0].value, 128.0);
}

class MapMistake : public testing::TestWithParam<ocean::test::Mistake> {};

TEST_P(MapMistake, IsNamedWithItsLine) {
    ocean::test::expect_refusal(ErrorKind::bad_file, GetParam().says, [] {
        parse_control_map(GetParam().text, "test.toml", ValueTable());
    });
}

INSTANTIATE_TEST_SUITE_P(Each, MapMistake,
                         testing::ValuesIn(ocean::test::mistakes("bridge/mistakes.toml", "maps")));

TEST(ControlMapFile, TheDefaultMapIsOne) {
    EXPECT_EQ(parse_control_map(kDefaultMap, "default", ValueTable()).maps.size(), 4u);
}

}  // namespace
}  // namespace ocean::bridge
