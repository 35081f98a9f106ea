// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "ocean/bridge/mapping.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "ocean/internal/checked_text.hpp"
#include "ocean/text.hpp"

namespace ocean::bridge {
namespace {

using Seconds = std::chrono::duration<double>;

/// Smoothed values are told as often as a take holds them.
constexpr auto kSmoothingStep = std::chrono::milliseconds(16);
/// How long a hand takes to let go.
constexpr auto kSettling = std::chrono::milliseconds(250);
/// Of the range: what is left then is no step that anybody sees.
constexpr double kArrived = 1e-3;

/// Six digits are more than a board has, and fit a line that people read.
double rounded(double value, const char* format = "%.6g") {
    double short_one = value;
    const std::string digits = format_text(format, value);
    std::from_chars(digits.data(), digits.data() + digits.size(), short_one);
    return short_one;
}

Clock::duration duration_of(double seconds) {
    return std::chrono::duration_cast<Clock::duration>(Seconds(seconds));
}

bool is_of(std::string_view board, std::string_view channel) {
    return channel.starts_with(board) && channel.substr(board.size()).starts_with('/');
}

double position(double value, const std::array<double, 2>& range) {
    return std::clamp((value - range[0]) / (range[1] - range[0]), 0.0, 1.0);
}

}  // namespace

double curved(Curve curve, double gamma, double x) {
    constexpr double kBend = 100.0;
    switch (curve) {
        case Curve::smoothstep:
            return x * x * (3.0 - 2.0 * x);
        case Curve::exp:
            return (std::pow(kBend, x) - 1.0) / (kBend - 1.0);
        case Curve::log:
            return std::log1p((kBend - 1.0) * x) / std::log(kBend);
        case Curve::gamma:
            return std::pow(x, gamma);
        case Curve::linear:
            break;
    }
    return x;
}

int relative_steps(RelativeCode code, double byte) {
    constexpr int kHalf = 64;
    if (!(byte >= 0.0 && byte < 2.0 * kHalf)) return 0;
    const int value = static_cast<int>(byte);
    switch (code) {
        case RelativeCode::twos_complement:
            return value < kHalf ? value : value - 2 * kHalf;
        case RelativeCode::binary_offset:
            return value - kHalf;
        case RelativeCode::signed_bit:
            break;
    }
    return value < kHalf ? value : kHalf - value;
}

/// A channel whose place is a value.
class Mapping::Knob {
  public:
    Knob(MapRule rule, std::size_t entry) : rule_(std::move(rule)), entry_(entry) {}

    const std::string& channel() const { return rule_.from; }

    std::optional<Setting> report(const Report& report, const ValueTable& values) {
        if (!held_) {
            held_ = report.value;
            target_ = shown_ = told_ = value_at(*held_);
            at_ = report.time;
            return std::nullopt;
        }
        if (!counts(report)) return std::nullopt;
        held_ = report.value;
        follow(report.time);
        target_ = value_at(*held_);
        return tell(values);
    }

    std::optional<Setting> advance(Clock::time_point now, const ValueTable& values) {
        if (!next() || now < *next()) return std::nullopt;
        follow(now);
        return tell(values);
    }

    std::optional<Clock::time_point> next() const {
        if (shown_ == target_) return std::nullopt;
        return at_ + kSmoothingStep;
    }

    void forget_place() { held_.reset(); }

  private:
    /// A step larger than noise moves the knob; for a moment afterwards every step counts, so that
    /// it ends where the hand left it. At rest noise is nothing.
    bool counts(const Report& report) {
        const double step = std::abs(report.value - *held_);
        if (step > rule_.hysteresis) moved_ = report.time;
        return step > 0.0 && moved_ && report.time - *moved_ < kSettling;
    }

    double value_at(double held) const {
        double x = position(held, rule_.in);
        if (rule_.deadzone > 0.0) {
            const double half = (rule_.in[1] - rule_.in[0]) / 2.0;
            const double zone = rule_.deadzone / half;
            const double off = 2.0 * x - 1.0;
            const double beyond = std::max(std::abs(off) - zone, 0.0) / (1.0 - zone);
            x = 0.5 + 0.5 * std::copysign(beyond, off);
        }
        if (rule_.invert) x = 1.0 - x;
        return std::lerp(rule_.out[0], rule_.out[1], curved(rule_.curve, rule_.gamma, x));
    }

    /// One pole, exact for a knob that stood still since: how often it is asked does not matter.
    void follow(Clock::time_point now) {
        const double elapsed = std::max(Seconds(now - at_).count(), 0.0);
        at_ = std::max(at_, now);
        const double left = rule_.smoothing > 0.0 ? std::exp(-elapsed / rule_.smoothing) : 0.0;
        shown_ = target_ + (shown_ - target_) * left;
        settle();
    }
    void settle() {
        if (std::abs(shown_ - target_) <= kArrived * std::abs(rule_.out[1] - rule_.out[0])) {
            shown_ = target_;
        }
    }

    std::optional<Setting> tell(const ValueTable& values) {
        if (rule_.smoothing == 0.0) shown_ = target_;
        const double before = std::exchange(told_, shown_);
        if (before == shown_) return std::nullopt;
        const double current = values.number(entry_);
        const bool ours = values[entry_].writer == rule_.from;
        double value = shown_;
        if (rule_.takeover == Takeover::pickup && !ours) {
            const bool crossed = (before - current) * (shown_ - current) <= 0.0;
            if (!crossed) return std::nullopt;
        } else if (rule_.takeover == Takeover::scale && !ours_in_place(ours, before, current)) {
            // The way that is left to the end, shared out over the way that the knob has left.
            const double end = shown_ > before ? std::max(rule_.out[0], rule_.out[1])
                                               : std::min(rule_.out[0], rule_.out[1]);
            value = current + (shown_ - before) * (end - current) / (end - before);
        }
        return Setting{entry_, rounded(value), rule_.from};
    }
    static bool ours_in_place(bool ours, double before, double current) {
        return ours && rounded(before) == current;
    }

    MapRule rule_;
    std::size_t entry_;
    std::optional<double> held_;              // the knob's place, its noise taken off
    std::optional<Clock::time_point> moved_;  // by more than noise
    double target_ = 0.0;                     // what it means
    double shown_ = 0.0;                      // on its way there
    double told_ = 0.0;
    Clock::time_point at_{};
};

/// A channel that is pressed or not.
class Mapping::Button {
  public:
    Button(MapRule rule, std::size_t entry) : rule_(std::move(rule)), entry_(entry) {}

    const std::string& channel() const { return rule_.from; }

    std::optional<Setting> report(const Report& report, const ValueTable& values) {
        const bool high = report.value > 0.5;
        const bool inverted = rule_.invert != (rule_.edge == Edge::fall);
        const bool pressed = high != inverted;
        if (!known_) {
            known_ = true;
            pressed_ = seen_ = pressed != report.moved;
        }
        seen_ = pressed;
        return settle(report.time, values);
    }

    std::optional<Setting> advance(Clock::time_point now, const ValueTable& values) {
        return settle(now, values);
    }

    std::optional<Clock::time_point> next() const {
        if (seen_ == pressed_) return std::nullopt;
        return rests_from_;
    }

    void forget_place() { known_ = false; }
    std::optional<Setting> let_go() {
        if (rule_.mode != Mode::momentary || !pressed_) return std::nullopt;
        pressed_ = seen_ = false;
        return setting(rule_.out[0]);
    }

  private:
    /// The first touch counts at once; what a contact does in the time after it does not.
    std::optional<Setting> settle(Clock::time_point now, const ValueTable& values) {
        if (seen_ == pressed_ || now < rests_from_) return std::nullopt;
        pressed_ = seen_;
        rests_from_ = now + duration_of(rule_.debounce);
        if (rule_.mode == Mode::momentary) return setting(pressed_ ? rule_.out[1] : rule_.out[0]);
        if (!pressed_) return std::nullopt;
        const bool back = rule_.mode == Mode::toggle && values.number(entry_) == rule_.out[1];
        return setting(back ? rule_.out[0] : rule_.out[1]);
    }
    Setting setting(double value) const { return {entry_, value, rule_.from}; }

    MapRule rule_;
    std::size_t entry_;
    bool known_ = false;
    bool pressed_ = false;
    bool seen_ = false;  // as the last report has it
    Clock::time_point rests_from_{};
};

/// A channel that counts and goes round when it is full, or says by how much it was turned.
class Mapping::Counter {
  public:
    Counter(MapRule rule, std::size_t entry) : rule_(std::move(rule)), entry_(entry) {}

    const std::string& channel() const { return rule_.from; }

    std::optional<Setting> report(const Report& report, const ValueTable& values) {
        const double counts = counts_of(report);
        if (counts == 0.0) return std::nullopt;
        const double current = values.number(entry_);
        const double value = inside(current, current + rule_.step * counts);
        return Setting{entry_, rounded(value, "%.12g"), rule_.from};  // whole ones stay whole
    }

    std::optional<Setting> advance(Clock::time_point, const ValueTable&) { return std::nullopt; }
    std::optional<Clock::time_point> next() const { return std::nullopt; }

    void forget_place() { count_.reset(); }

  private:
    double counts_of(const Report& report) {
        if (rule_.mode == Mode::relative) return relative_steps(rule_.code, report.value);
        const double before = std::exchange(count_, report.value).value_or(report.value);
        const double round = rule_.in[1] - rule_.in[0] + 1.0;
        return std::remainder(report.value - before, round);
    }
    /// A value that another hand has put outside of `out` comes back step by step, and not at once.
    double inside(double current, double value) const {
        const auto [lowest, highest] = rule_.out;
        if (!rule_.wrap) {
            return std::clamp(value, std::min(lowest, current), std::max(highest, current));
        }
        const double width = highest - lowest;
        return value - width * std::floor((value - lowest) / width);
    }

    MapRule rule_;
    std::size_t entry_;
    std::optional<double> count_;
};

struct Mapping::State {
    struct Out {
        OutRule rule;
        std::size_t entry;
        std::optional<double> told;
    };
    std::vector<Knob> knobs;
    std::vector<Button> buttons;
    std::vector<Counter> counters;
    std::vector<Out> outs;

    template <typename Function>
    void for_each(const Function& function) {
        for (Knob& knob : knobs) function(knob);
        for (Button& button : buttons) function(button);
        for (Counter& counter : counters) function(counter);
    }
};

Mapping::Mapping(MapFile file, const ValueTable& values) : state_(std::make_unique<State>()) {
    for (MapRule& rule : file.maps) {
        const std::size_t entry = values.find(rule.to);
        if (rule.mode == Mode::range) {
            state_->knobs.emplace_back(std::move(rule), entry);
        } else if (rule.mode == Mode::increment || rule.mode == Mode::relative) {
            state_->counters.emplace_back(std::move(rule), entry);
        } else {
            state_->buttons.emplace_back(std::move(rule), entry);
        }
    }
    for (OutRule& rule : file.outs) {
        const std::size_t entry = values.find(rule.from);
        state_->outs.push_back({std::move(rule), entry, std::nullopt});
    }
}

Mapping::~Mapping() = default;
Mapping::Mapping(Mapping&&) noexcept = default;
Mapping& Mapping::operator=(Mapping&&) noexcept = default;

std::vector<Setting> Mapping::report(const Report& report, const ValueTable& values) {
    std::vector<Setting> settings;
    if (!std::isfinite(report.value)) return settings;
    state_->for_each([&](auto& control) {
        if (control.channel() != report.channel) return;
        if (auto setting = control.report(report, values)) settings.push_back(*setting);
    });
    return settings;
}

std::vector<Setting> Mapping::advance(Clock::time_point now, const ValueTable& values) {
    std::vector<Setting> settings;
    state_->for_each([&](auto& control) {
        if (auto setting = control.advance(now, values)) settings.push_back(*setting);
    });
    return settings;
}

std::optional<Clock::time_point> Mapping::next() const {
    std::optional<Clock::time_point> earliest;
    state_->for_each([&](const auto& control) {
        const auto next = control.next();
        if (next && (!earliest || *next < *earliest)) earliest = next;
    });
    return earliest;
}

std::vector<Lamp> Mapping::lamps(const ValueTable& values) {
    std::vector<Lamp> lamps;
    for (State::Out& out : state_->outs) {
        const double x = position(values.number(out.entry), out.rule.in);
        const double value = std::round(std::lerp(out.rule.out[0], out.rule.out[1], x));
        if (out.told == value) continue;
        out.told = value;
        lamps.push_back({out.rule.to, value});
    }
    return lamps;
}

void Mapping::board_connected(std::string_view board) {
    state_->for_each([&](auto& control) {
        if (is_of(board, control.channel())) control.forget_place();
    });
    for (State::Out& out : state_->outs) {
        if (is_of(board, out.rule.to)) out.told.reset();
    }
}

std::vector<Setting> Mapping::board_lost(std::string_view board) {
    std::vector<Setting> settings;
    for (Button& button : state_->buttons) {
        if (!is_of(board, button.channel())) continue;
        if (auto setting = button.let_go()) settings.push_back(*setting);
    }
    return settings;
}

}  // namespace ocean::bridge
