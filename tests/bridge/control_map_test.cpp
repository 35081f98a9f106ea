// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// From a knob to a value: ranges, curves, noise, smoothing, who holds the value; and a map that is
// wrong says where.
#include "ocean/internal/bridge/control_map.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <tuple>

#include "mistakes.hpp"
#include "refusal.hpp"

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

TEST(ControlMap, TheFirstReportOnlySaysWhereTheKnobIs) {
    Desk desk(knob(""));
    EXPECT_EQ(desk.turn(200), 0u);
    EXPECT_EQ(desk.turn(100), 1u);
    EXPECT_NEAR(desk.value(), 30.0 * 100 / 255, 1e-4);
}

TEST(ControlMap, TheRangeEndsAreReachedAndNotLeft) {
    Desk desk(knob("in = [4, 251]\nhysteresis = 0\n"));
    desk.turn(100);
    desk.turn(255);
    EXPECT_EQ(desk.value(), 30.0);
    desk.turn(0);
    EXPECT_EQ(desk.value(), 0.0);
    Desk inverted(knob("in = [4, 251]\ninvert = true\n"));
    inverted.turn(100);
    inverted.turn(255);
    EXPECT_EQ(inverted.value(), 0.0);
}

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
    Desk desk(knob("curve = \"gamma:2\"\nhysteresis = 0\nin = [0, 100]\n"));
    desk.turn(0);
    desk.turn(50);
    EXPECT_NEAR(desk.value(), 7.5, 1e-9);
}

TEST(ControlMap, AStickRestsInTheMiddle) {
    Desk desk(knob("in = [0, 200]\ndeadzone = 20\nhysteresis = 0\n"));
    desk.turn(0);
    for (const double raw : {80.0, 100.0, 120.0}) {
        desk.turn(raw);
        EXPECT_EQ(desk.value(), 15.0) << raw;
    }
    desk.turn(160);
    EXPECT_NEAR(desk.value(), 22.5, 1e-9);
    desk.turn(200);
    EXPECT_EQ(desk.value(), 30.0);
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

TEST(ControlMap, AnotherHandKeepsTheValueUntilTheKnobComesBy) {
    Desk desk(knob("takeover = \"pickup\"\nin = [0, 300]\nhysteresis = 0\n"));
    desk.write("wind_speed", "20");
    desk.turn(0);
    EXPECT_EQ(desk.turn(100), 0u);
    EXPECT_EQ(desk.value(), 20.0);
    EXPECT_EQ(desk.turn(210), 1u);  // past 20
    EXPECT_EQ(desk.value(), 21.0);
    EXPECT_EQ(desk.turn(100), 1u);
    EXPECT_EQ(desk.value(), 10.0);
    desk.write("wind_speed", "5");
    EXPECT_EQ(desk.turn(200), 0u);
    EXPECT_EQ(desk.value(), 5.0);
}

TEST(ControlMap, ScaledTakeoverMeetsTheKnobAtTheEnd) {
    Desk desk(knob("takeover = \"scale\"\nin = [0, 300]\nhysteresis = 0\n"));
    desk.write("wind_speed", "20");
    desk.turn(0);
    desk.turn(150);  // half of the way up: half of what is left above
    EXPECT_NEAR(desk.value(), 25.0, 1e-6);
    desk.turn(300);
    EXPECT_NEAR(desk.value(), 30.0, 1e-6);
    desk.turn(100);
    EXPECT_NEAR(desk.value(), 10.0, 1e-6);
}

/// As of a MIDI fader, whose place is not known before it is moved.
TEST(ControlMap, AKnobThatIsPickedUpNeedsToBeSeenOnBothSides) {
    Desk desk(knob("takeover = \"pickup\"\nin = [0, 127]\nhysteresis = 0\n"));
    desk.write("wind_speed", "15");
    EXPECT_EQ(desk.turn(100, "board0/a1", true), 0u);  // far above, and from nobody knows where
    EXPECT_EQ(desk.turn(90, "board0/a1", true), 0u);
    EXPECT_EQ(desk.turn(63, "board0/a1", true), 1u);
    EXPECT_NEAR(desk.value(), 30.0 * 63 / 127, 1e-4);
}

TEST(ControlMap, ABoardThatIsBackSetsNothing) {
    Desk desk(knob("hysteresis = 0\n"));
    desk.turn(0);
    EXPECT_EQ(desk.turn(100), 1u);
    desk.plug("board1");
    EXPECT_EQ(desk.turn(101), 1u);
    desk.plug();
    EXPECT_EQ(desk.turn(200), 0u);  // turned while it was away
    EXPECT_EQ(desk.turn(201), 1u);
    EXPECT_NEAR(desk.value(), 30.0 * 201 / 255, 1e-4);
}

std::string counter(const std::string& more) {
    return "[[map]]\nfrom = \"board0/c1\"\nto = \"wind_direction\"\nmode = \"increment\"\n" + more;
}

TEST(ControlMap, EachCountIsAStep) {
    Desk desk(counter("in = [0, 65535]\nout = [0, 90]\nstep = 5\n"));
    desk.write("wind_direction", "10");
    const auto count = [&](double raw) {
        const std::size_t settings = desk.turn(raw, "board0/c1");
        return settings == 0 ? -1.0 : desk.value("wind_direction");
    };
    EXPECT_EQ(count(65534), -1.0);  // where it stands
    EXPECT_EQ(count(65534), -1.0);
    EXPECT_EQ(count(65535), 15.0);
    EXPECT_EQ(count(1), 25.0);  // past its end
    EXPECT_EQ(count(65535), 15.0);
    desk.write("wind_direction", "80");
    EXPECT_EQ(count(2), 90.0);  // the end of out
    EXPECT_EQ(count(1), 85.0);
    desk.plug();
    EXPECT_EQ(count(7), -1.0);
}

TEST(ControlMap, CountsGoRoundInsideOut) {
    Desk desk(counter("in = [0, 127]\nout = [0, 360]\nstep = -50\nwrap = true\n"));
    desk.write("wind_direction", "70");
    desk.turn(0, "board0/c1");
    desk.turn(2, "board0/c1");
    EXPECT_EQ(desk.value("wind_direction"), 330.0);
    desk.turn(126, "board0/c1");
    EXPECT_EQ(desk.value("wind_direction"), 170.0);
    desk.turn(0, "board0/c1");
    desk.turn(100, "board0/c1");  // 28 back is shorter than 100 forth
    EXPECT_EQ(desk.value("wind_direction"), 30.0);
}

TEST(ControlMap, LargeWholeNumbersAreCountedToo) {
    Desk desk(
        "[[map]]\nfrom = \"board0/c1\"\nto = \"seed\"\nmode = \"increment\"\nout = [0, 9999999]\n");
    desk.write("seed", "1234567");
    desk.turn(0, "board0/c1");
    desk.turn(1, "board0/c1");
    EXPECT_EQ(desk.value("seed"), 1234568.0);
}

std::string endless(const std::string& code, const std::string& more = "") {
    return "[[map]]\nfrom = \"m/cc16\"\nto = \"wind_speed\"\nmode = \"relative\"\ncode = \"" +
           code + "\"\nout = [0, 30]\n" + more;
}

/// Returns the value after a byte of the endless knob.
double turned(Desk& desk, int byte, const std::string& name = "wind_speed") {
    desk.turn(byte, "m/cc16", true);
    return desk.value(name);
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
        Desk desk(endless(code));
        desk.write("wind_speed", "12");
        const auto turn = [&](int byte) { return turned(desk, byte); };
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

TEST(ControlMap, AnEndlessKnobEndsAtTheEndsOfItsRange) {
    Desk desk(endless("twos_complement", "step = 5\n"));
    const auto turn = [&](int byte) { return turned(desk, byte); };
    desk.write("wind_speed", "22");
    EXPECT_EQ(turn(2), 30.0);
    EXPECT_EQ(turn(1), 30.0);
    EXPECT_EQ(turn(0x7F), 25.0);
    EXPECT_EQ(turn(0x40), 0.0);
    EXPECT_EQ(turn(0x7F), 0.0);
    desk.write("wind_speed", "50");  // beyond `out`: it comes back and does not jump
    EXPECT_EQ(turn(1), 50.0);
    EXPECT_EQ(turn(0x7F), 45.0);
    EXPECT_EQ(turn(1), 45.0);
    Desk backwards(endless("twos_complement", "step = -0.5\n"));
    backwards.write("wind_speed", "10");
    EXPECT_EQ(turned(backwards, 1), 9.5);
    Desk round(
        "[[map]]\nfrom = \"m/cc16\"\nto = \"wind_direction\"\nmode = \"relative\"\ncode = "
        "\"signed_bit\"\nout = [0, 360]\nwrap = true\n");
    round.write("wind_direction", "358");
    EXPECT_NEAR(turned(round, 1, "wind_direction"), 1.6, 1e-9);
    // The step of a whole number is at least one.
    Desk whole(
        "[[map]]\nfrom = \"m/cc16\"\nto = \"seed\"\nmode = \"relative\"\ncode = "
        "\"signed_bit\"\nout = [0, 20]\n");
    whole.write("seed", "7");
    EXPECT_EQ(turned(whole, 1, "seed"), 8.0);
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

std::string button(const std::string& mode, const std::string& more = "") {
    return "[[map]]\nfrom = \"board0/d1\"\nto = \"app.pause\"\nmode = \"" + mode + "\"\n" + more;
}

TEST(ControlMap, ButtonsToggleHoldAndTrigger) {
    const auto press = [](Desk& desk, int value) {
        desk.turn(value, "board0/d1");
        desk.pass(100ms);
        return desk.value("app.pause");
    };
    Desk toggle(button("toggle"));
    EXPECT_EQ(press(toggle, 0), 0.0);
    EXPECT_EQ(press(toggle, 1), 1.0);
    EXPECT_EQ(press(toggle, 0), 1.0);
    EXPECT_EQ(press(toggle, 1), 0.0);
    toggle.write("app.pause", "1");
    press(toggle, 0);
    EXPECT_EQ(press(toggle, 1), 0.0);  // of what it is, whoever made it so
    Desk momentary(button("momentary"));
    EXPECT_EQ(press(momentary, 0), 0.0);
    EXPECT_EQ(press(momentary, 1), 1.0);
    EXPECT_EQ(press(momentary, 0), 0.0);
    Desk trigger(button("trigger", "edge = \"fall\"\n"));
    EXPECT_EQ(press(trigger, 1), 0.0);
    EXPECT_EQ(press(trigger, 0), 1.0);
    EXPECT_EQ(press(trigger, 1), 1.0);
}

/// A board that does not say where its buttons rest says when they are pressed.
TEST(ControlMap, TheFirstPressCountsWhereAHandIsSeen) {
    Desk desk(button("toggle"));
    desk.turn(127, "board0/d1", true);
    EXPECT_EQ(desk.value("app.pause"), 1.0);
    desk.pass(100ms);
    desk.turn(0, "board0/d1", true);
    desk.pass(100ms);
    desk.turn(127, "board0/d1", true);
    EXPECT_EQ(desk.value("app.pause"), 0.0);
    desk.pass(100ms);
    desk.plug();
    desk.turn(127, "board0/d1", true);  // let go while it was away
    EXPECT_EQ(desk.value("app.pause"), 1.0);
    Desk known(button("toggle"));
    known.turn(1, "board0/d1");
    EXPECT_EQ(known.value("app.pause"), 0.0);
}

TEST(ControlMap, AContactThatBouncesIsOnePress) {
    Desk desk(button("toggle", "debounce_ms = 20\n"));
    desk.turn(0, "board0/d1");
    for (int bounce = 0; bounce < 5; ++bounce) {
        desk.turn(1, "board0/d1");
        desk.pass(1ms);
        desk.turn(0, "board0/d1");
        desk.pass(1ms);
    }
    desk.turn(1, "board0/d1");
    desk.pass(200ms);
    EXPECT_EQ(desk.value("app.pause"), 1.0);
    // Released within the time that is not looked at: seen when it is over.
    Desk momentary(button("momentary", "debounce_ms = 20\n"));
    momentary.turn(0, "board0/d1");
    momentary.turn(1, "board0/d1");
    momentary.pass(5ms);
    momentary.turn(0, "board0/d1");
    EXPECT_EQ(momentary.value("app.pause"), 1.0);
    momentary.pass(50ms);
    EXPECT_EQ(momentary.value("app.pause"), 0.0);
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
