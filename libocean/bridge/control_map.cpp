// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "ocean/internal/bridge/control_map.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "ocean/internal/text.hpp"

namespace ocean::bridge {
namespace {

using Seconds = std::chrono::duration<double>;

/// Smoothed values change about as often as a take can hold them.
constexpr auto kSmoothingStep = std::chrono::milliseconds(16);
/// The time that a hand needs to let go of a knob.
constexpr auto kSettlingTime = std::chrono::milliseconds(250);
/// A smoothed value that is this close to its target, relative to the range, has arrived: the rest
/// is invisible.
constexpr double kArrived = 1e-3;

/// Rounds to six digits: more than a board resolves, and short in a line that people read.
double rounded(double value, const char* format = "%.6g") {
    double short_value = value;
    const std::string digits = format_text(format, value);
    std::from_chars(digits.data(), digits.data() + digits.size(), short_value);
    return short_value;
}

Clock::duration duration_of(double seconds) {
    return std::chrono::duration_cast<Clock::duration>(Seconds(seconds));
}

bool belongs_to(std::string_view board, std::string_view channel) {
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

/// A channel whose position is a value.
class ControlMap::Knob {
  public:
    Knob(ControlRule rule, std::size_t entry) : rule_(std::move(rule)), entry_(entry) {}

    const std::string& channel() const { return rule_.from; }

    std::optional<Setting> report(const Report& report, const ValueTable& values) {
        if (!held_) {
            held_ = report.value;
            target_ = shown_ = requested_ = value_at(*held_);
            at_ = report.time;
            return std::nullopt;
        }
        if (!counts(report)) return std::nullopt;
        held_ = report.value;
        follow(report.time);
        target_ = value_at(*held_);
        return request(values);
    }

    std::optional<Setting> advance(Clock::time_point now, const ValueTable& values) {
        if (!next() || now < *next()) return std::nullopt;
        follow(now);
        return request(values);
    }

    std::optional<Clock::time_point> next() const {
        if (shown_ == target_) return std::nullopt;
        return at_ + kSmoothingStep;
    }

    void forget_position() { held_.reset(); }

  private:
    /// Returns true if the report moves the knob. A step larger than the hysteresis does; for
    /// kSettlingTime afterwards every step does, so that the knob ends where the hand left it.
    bool counts(const Report& report) {
        const double step = std::abs(report.value - *held_);
        if (step > rule_.hysteresis) moved_ = report.time;
        return step > 0.0 && moved_ && report.time - *moved_ < kSettlingTime;
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

    /// Moves shown_ towards target_ by a one-pole filter, exactly for a target that has not changed
    /// since at_: the result does not depend on how often the function is called.
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

    std::optional<Setting> request(const ValueTable& values) {
        if (rule_.smoothing == 0.0) shown_ = target_;
        const double before = std::exchange(requested_, shown_);
        if (before == shown_) return std::nullopt;
        const double current = values.number(entry_);
        const bool is_ours = values[entry_].writer == rule_.from;
        double value = shown_;
        if (rule_.takeover == Takeover::pickup && !is_ours) {
            const bool crossed = (before - current) * (shown_ - current) <= 0.0;
            if (!crossed) return std::nullopt;
        } else if (rule_.takeover == Takeover::scale && !is_in_place(is_ours, before, current)) {
            // Spreads the value's distance to the end over the knob's distance to its end.
            const double end = shown_ > before ? std::max(rule_.out[0], rule_.out[1])
                                               : std::min(rule_.out[0], rule_.out[1]);
            value = current + (shown_ - before) * (end - current) / (end - before);
        }
        return Setting{entry_, rounded(value), rule_.from};
    }
    static bool is_in_place(bool is_ours, double before, double current) {
        return is_ours && rounded(before) == current;
    }

    ControlRule rule_;
    std::size_t entry_;
    std::optional<double> held_;              // position without noise
    std::optional<Clock::time_point> moved_;  // last step larger than noise
    double target_ = 0.0;                     // the value of the position
    double shown_ = 0.0;                      // the smoothed value
    double requested_ = 0.0;                  // shown_ at the last request
    Clock::time_point at_{};
};

/// A channel that is pressed or released.
class ControlMap::Button {
  public:
    Button(ControlRule rule, std::size_t entry) : rule_(std::move(rule)), entry_(entry) {}

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
        return settled_at_;
    }

    void forget_position() { known_ = false; }
    std::optional<Setting> release() {
        if (rule_.mode != Mode::momentary || !pressed_) return std::nullopt;
        pressed_ = seen_ = false;
        return setting(rule_.out[0]);
    }

  private:
    /// Accepts the first change at once and ignores further ones for the debounce time.
    std::optional<Setting> settle(Clock::time_point now, const ValueTable& values) {
        if (seen_ == pressed_ || now < settled_at_) return std::nullopt;
        pressed_ = seen_;
        settled_at_ = now + duration_of(rule_.debounce);
        if (rule_.mode == Mode::momentary) return setting(pressed_ ? rule_.out[1] : rule_.out[0]);
        if (!pressed_) return std::nullopt;
        const bool back = rule_.mode == Mode::toggle && values.number(entry_) == rule_.out[1];
        return setting(back ? rule_.out[0] : rule_.out[1]);
    }
    Setting setting(double value) const { return {entry_, value, rule_.from}; }

    ControlRule rule_;
    std::size_t entry_;
    bool known_ = false;
    bool pressed_ = false;
    bool seen_ = false;  // in the last report
    Clock::time_point settled_at_{};
};

/// A counter, which wraps around at the end of `in`, or an endless knob, which reports steps.
class ControlMap::Counter {
  public:
    Counter(ControlRule rule, std::size_t entry) : rule_(std::move(rule)), entry_(entry) {}

    const std::string& channel() const { return rule_.from; }

    std::optional<Setting> report(const Report& report, const ValueTable& values) {
        const double counts = counts_of(report);
        if (counts == 0.0) return std::nullopt;
        const double current = values.number(entry_);
        const double value = limited(current, current + rule_.step * counts);
        return Setting{entry_, rounded(value, "%.12g"), rule_.from};  // keeps whole numbers whole
    }

    std::optional<Setting> advance(Clock::time_point, const ValueTable&) { return std::nullopt; }
    std::optional<Clock::time_point> next() const { return std::nullopt; }

    void forget_position() { count_.reset(); }

  private:
    double counts_of(const Report& report) {
        if (rule_.mode == Mode::relative) return relative_steps(rule_.code, report.value);
        const double before = std::exchange(count_, report.value).value_or(report.value);
        const double round = rule_.in[1] - rule_.in[0] + 1.0;
        return std::remainder(report.value - before, round);
    }
    /// Limits the value to `out`. A current value outside of `out`, which another writer has set,
    /// returns step by step.
    double limited(double current, double value) const {
        const auto [min, max] = rule_.out;
        if (!rule_.wrap) {
            return std::clamp(value, std::min(min, current), std::max(max, current));
        }
        const double width = max - min;
        return value - width * std::floor((value - min) / width);
    }

    ControlRule rule_;
    std::size_t entry_;
    std::optional<double> count_;
};

struct ControlMap::Impl {
    struct Out {
        OutRule rule;
        std::size_t entry;
        std::optional<double> value;  // at the last call of changed_outputs()
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

ControlMap::ControlMap(ControlMapFile file, const ValueTable& values)
    : impl_(std::make_unique<Impl>()) {
    for (ControlRule& rule : file.maps) {
        const std::size_t entry = values.find(rule.to);
        if (rule.mode == Mode::range) {
            impl_->knobs.emplace_back(std::move(rule), entry);
        } else if (rule.mode == Mode::increment || rule.mode == Mode::relative) {
            impl_->counters.emplace_back(std::move(rule), entry);
        } else {
            impl_->buttons.emplace_back(std::move(rule), entry);
        }
    }
    for (OutRule& rule : file.outs) {
        const std::size_t entry = values.find(rule.from);
        impl_->outs.push_back({std::move(rule), entry, std::nullopt});
    }
}

ControlMap::~ControlMap() = default;
ControlMap::ControlMap(ControlMap&&) noexcept = default;
ControlMap& ControlMap::operator=(ControlMap&&) noexcept = default;

std::vector<Setting> ControlMap::report(const Report& report, const ValueTable& values) {
    std::vector<Setting> settings;
    if (!std::isfinite(report.value)) return settings;
    impl_->for_each([&](auto& control) {
        if (control.channel() != report.channel) return;
        if (auto setting = control.report(report, values)) settings.push_back(*setting);
    });
    return settings;
}

std::vector<Setting> ControlMap::advance(Clock::time_point now, const ValueTable& values) {
    std::vector<Setting> settings;
    impl_->for_each([&](auto& control) {
        if (auto setting = control.advance(now, values)) settings.push_back(*setting);
    });
    return settings;
}

std::optional<Clock::time_point> ControlMap::next() const {
    std::optional<Clock::time_point> earliest;
    impl_->for_each([&](const auto& control) {
        const auto next = control.next();
        if (next && (!earliest || *next < *earliest)) earliest = next;
    });
    return earliest;
}

std::vector<OutputValue> ControlMap::changed_outputs(const ValueTable& values) {
    std::vector<OutputValue> changed;
    for (Impl::Out& out : impl_->outs) {
        const double x = position(values.number(out.entry), out.rule.in);
        const double value = std::round(std::lerp(out.rule.out[0], out.rule.out[1], x));
        if (out.value == value) continue;
        out.value = value;
        changed.push_back({out.rule.to, value});
    }
    return changed;
}

void ControlMap::board_connected(std::string_view board) {
    impl_->for_each([&](auto& control) {
        if (belongs_to(board, control.channel())) control.forget_position();
    });
    for (Impl::Out& out : impl_->outs) {
        if (belongs_to(board, out.rule.to)) out.value.reset();
    }
}

std::vector<Setting> ControlMap::board_lost(std::string_view board) {
    std::vector<Setting> settings;
    for (Button& button : impl_->buttons) {
        if (!belongs_to(board, button.channel())) continue;
        if (auto setting = button.release()) settings.push_back(*setting);
    }
    return settings;
}

}  // namespace ocean::bridge
