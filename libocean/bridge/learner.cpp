// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "ocean/internal/bridge/learner.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ocean/enum_words.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/bridge/control_map.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/text.hpp"

namespace ocean::bridge {
namespace {

/// A control that does not move for this time has come to rest.
constexpr auto kRestTime = std::chrono::milliseconds(400);
constexpr std::size_t kMaxValues = 512;
/// A knob is moved on purpose if it travels an eighth of its range. A step above a 64th is not
/// noise.
constexpr double kMinTravel = 1.0 / 8.0;
constexpr double kNoise = 1.0 / 64.0;
/// Endless knobs report few steps at once, and often repeat the same number.
constexpr int kMaxSteps = 16;
constexpr std::size_t kMinRepeats = 2;
constexpr int kPairs = 32;

std::string_view wire_of(std::string_view channel) {
    return channel.substr(channel.find('/') + 1);
}

std::string_view letters_of(std::string_view channel) {
    const std::string_view wire = wire_of(channel);
    return wire.substr(0, wire.find_first_of("0123456789"));
}

int number_of(std::string_view channel) {
    const std::string_view digits = wire_of(channel).substr(letters_of(channel).size());
    return static_cast<int>(text::parse_number(digits).value_or(0.0));
}

bool is_one_of(std::string_view word, std::initializer_list<std::string_view> words) {
    return std::ranges::find(words, word) != words.end();
}

/// Returns true for channels whose letters only MIDI controllers have.
bool is_midi(std::string_view channel) {
    return is_one_of(letters_of(channel), {"cc", "n", "pb", "pair", "nrpn", "rpn"});
}

std::array<double, 2> range_of(std::string_view channel, const Channel* known) {
    const std::string_view letters = letters_of(channel);
    if (letters == "cc") return {0.0, 127.0};
    if (is_one_of(letters, {"pb", "pair", "nrpn", "rpn"})) return {0.0, 16383.0};
    // A replay knows the channel's name, but not its range.
    constexpr double kMaxRange = 1e6;
    if (known != nullptr && known->max < kMaxRange) return {known->min, known->max};
    return letters == "c" ? std::array{0.0, 65535.0} : std::array{0.0, 255.0};
}

std::size_t repeats(const std::vector<double>& values) {
    std::size_t count = 0;
    for (std::size_t i = 1; i < values.size(); ++i) count += values[i] == values[i - 1] ? 1 : 0;
    return count;
}

/// The fit of a code: all values may be its steps, and they go in both directions.
struct CodeFit {
    bool fits = false;
    bool both_ways = false;
};
CodeFit fit_of(RelativeCode code, const std::vector<double>& values) {
    bool up = false;
    bool down = false;
    for (const double value : values) {
        const int steps = relative_steps(code, value);
        if (steps == 0 || std::abs(steps) > kMaxSteps) return {};
        (steps > 0 ? up : down) = true;
    }
    return {true, up && down};
}

std::string list_of(const std::array<double, 2>& range) {
    return "[" + plain_text(range[0]) + ", " + plain_text(range[1]) + "]";
}

std::string as_knob(const std::array<double, 2>& range, bool is_exact) {
    const std::string in = "in = " + list_of(range) + "\n";
    return is_exact ? in + "hysteresis = 0\ntakeover = \"pickup\"\n" : in;
}

/// A controller of 7 bits that has been identified: a button, or a knob with these lines.
struct SevenBits {
    bool is_button = false;
    std::string lines;
};
std::optional<SevenBits> seven_bits(const std::vector<double>& values) {
    const auto [low, high] = std::ranges::minmax(values);
    const bool has_two_values = std::ranges::all_of(
        values, [low = low, high = high](double x) { return x == low || x == high; });
    if (has_two_values && low == 0.0 && high > 0.0) return SevenBits{true, ""};
    bool may_turn = false;
    for (std::size_t i = 0; i < kEnumWords<RelativeCode>.size(); ++i) {
        const auto code = static_cast<RelativeCode>(i);
        const CodeFit fit = fit_of(code, values);
        if (fit.both_ways && repeats(values) >= kMinRepeats) {
            const std::string word(word_of(code));
            return SevenBits{false, "mode = \"relative\"\ncode = \"" + word + "\"\n"};
        }
        may_turn = may_turn || fit.fits;
    }
    constexpr std::array kFullRange = {0.0, 127.0};
    if (may_turn || high - low < kMinTravel * kFullRange[1]) return std::nullopt;
    return SevenBits{false, as_knob(kFullRange, true)};
}

}  // namespace

Learner::Learner(const ValueTable& values, const std::string& to) {
    const auto target = [&](const std::string& name) -> Target {
        const std::size_t entry = values.find(name);
        if (!values.is_number(entry)) {
            throw Error(ErrorKind::invalid_value,
                        name + " is not a number, which a knob could set");
        }
        if (const ParameterInfo* info = values.parameter(entry)) {
            return {name, {info->soft_min, info->soft_max}};
        }
        const auto app = std::ranges::find(app_values(), values[entry].name, &AppValue::name);
        return {name, {app->min, app->max}};
    };
    knob_ = target(to.empty() ? "wind_speed" : to);
    button_ = target(to.empty() ? "app.pause" : to);
    const double hundredth = (knob_.out[1] - knob_.out[0]) / 100.0;
    step_ =
        plain_text(values.is_whole(values.find(knob_.name)) ? std::max(std::round(hundredth), 1.0)
                                                            : hundredth);
}

void Learner::report(const Report& report, const Channel* channel) {
    if (!std::isfinite(report.value) || letters_of(report.channel) == "pair") return;
    const bool midi = is_midi(report.channel);
    Group& group =
        groups_[midi ? report.channel.substr(0, report.channel.find('/')) : report.channel];
    Gesture& gesture = group.gestures[report.channel];
    gesture.range = range_of(report.channel, channel);
    if (!midi) {
        const double before = gesture.rest.value_or(report.value);
        const double noise = letters_of(report.channel) == "a"
                                 ? kNoise * (gesture.range[1] - gesture.range[0])
                                 : 0.0;
        if (!gesture.rest) gesture.rest = report.value;
        if (std::abs(report.value - before) <= noise) return;
        if (gesture.values.empty()) gesture.values.push_back(before);
        gesture.rest = report.value;
    }
    if (gesture.values.size() == kMaxValues) {
        gesture.values.erase(gesture.values.begin(), gesture.values.begin() + kMaxValues / 2);
    }
    gesture.values.push_back(report.value);
    group.moved = report.time;
    if (letters_of(report.channel) != "cc") return;
    const std::string before = std::exchange(group.latest_controller, report.channel);
    if (letters_of(before) != "cc" || number_of(before) >= kPairs ||
        number_of(before) + kPairs != number_of(report.channel)) {
        return;
    }
    ++gesture.coarse_then_fine;
    ++group.gestures[before].coarse_then_fine;
}

std::optional<Clock::time_point> Learner::next() const {
    std::optional<Clock::time_point> earliest;
    for (const auto& [name, group] : groups_) {
        if (group.moved && (!earliest || *group.moved + kRestTime < *earliest)) {
            earliest = *group.moved + kRestTime;
        }
    }
    return earliest;
}

std::vector<Lesson> Learner::advance(Clock::time_point now) {
    std::vector<Lesson> lessons;
    for (auto& [name, group] : groups_) {
        if (!group.moved || now < *group.moved + kRestTime) continue;
        group.moved.reset();
        learn(group, lessons);
    }
    return lessons;
}

void Learner::learn(Group& group, std::vector<Lesson>& lessons) {
    const auto add_map = [&](const std::string& map) {
        if (std::exchange(last_map_, map) != map) lessons.push_back({true, map});
    };
    // NRPN and RPN come together with the controllers that select and carry them.
    const bool has_number = std::ranges::any_of(group.gestures, [](const auto& gesture) {
        return is_one_of(letters_of(gesture.first), {"nrpn", "rpn"});
    });
    std::map<std::string, Gesture> open;
    for (auto& [channel, gesture] : group.gestures) {
        const int number = letters_of(channel) == "cc" ? number_of(channel) : -1;
        if (has_number && (number == 6 || number == 38 || (number >= 98 && number <= 101))) {
            continue;
        }
        if (number >= kPairs && gesture.coarse_then_fine > 0)
            continue;  // learnt with its coarse controller
        const std::size_t coarse = gesture.values.size();
        if (gesture.coarse_then_fine >= 2 && 3 * gesture.coarse_then_fine >= 2 * coarse) {
            const std::string board = channel.substr(0, channel.find('/'));
            add_map(lines(board + "/pair" + std::to_string(number), knob_,
                          as_knob({0.0, 16383.0}, true)));
            continue;
        }
        if (const auto map = map_of(channel, gesture)) {
            add_map(*map);
        } else if (!gesture.values.empty()) {
            if (!std::exchange(gesture.hinted, true)) {
                lessons.push_back(
                    {false, channel + " = " + plain_text(gesture.values.back()) +
                                ": move it further, an endless knob in both directions"});
            }
            open.emplace(channel, std::move(gesture));
        } else if (gesture.rest) {
            open.emplace(channel, std::move(gesture));
        }
    }
    // A board with positions continues from the present ones.
    for (auto& [channel, gesture] : group.gestures) {
        if (gesture.rest && !open.contains(channel)) {
            open[channel].rest = gesture.rest;
            open[channel].range = gesture.range;
        }
    }
    group.gestures = std::move(open);
}

std::optional<std::string> Learner::map_of(const std::string& channel,
                                           const Gesture& gesture) const {
    const std::vector<double>& values = gesture.values;
    const std::string_view letters = letters_of(channel);
    const std::string toggle = "mode = \"toggle\"\n";
    if (values.empty()) return std::nullopt;
    if (is_one_of(letters, {"n", "d"})) return lines(channel, button_, toggle);
    if (letters == "c") {
        return lines(
            channel, knob_,
            "mode = \"increment\"\nin = " + list_of(gesture.range) + "\nstep = " + step_ + "\n");
    }
    if (letters == "cc") {
        const auto found = seven_bits(values);
        if (!found) return std::nullopt;
        if (found->is_button) return lines(channel, button_, toggle);
        const bool turns = found->lines.starts_with("mode");
        return lines(channel, knob_,
                     turns ? found->lines + "step = " + step_ + "\n" : found->lines);
    }
    const auto [low, high] = std::ranges::minmax(values);
    if (high - low < kMinTravel * (gesture.range[1] - gesture.range[0])) return std::nullopt;
    std::array<double, 2> range = gesture.range;
    // The range of a device that never sends the fine byte ends below the max of 14 bits.
    constexpr double kCoarse = 128.0;
    const bool is_coarse =
        is_one_of(letters, {"nrpn", "rpn"}) && std::ranges::all_of(values, [](double value) {
            return std::remainder(value, kCoarse) == 0.0;
        });
    if (is_coarse) range[1] = 127.0 * kCoarse;
    return lines(channel, knob_, as_knob(range, is_midi(channel)));
}

std::string Learner::lines(const std::string& channel, const Target& target,
                           const std::string& more) const {
    return "[[map]]\nfrom = \"" + channel + "\"\nto = \"" + target.name + "\"\n" + more +
           "out = " + list_of(target.out) + "\n";
}

}  // namespace ocean::bridge
