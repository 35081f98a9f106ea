// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "midi_messages.hpp"

#include <algorithm>

namespace ocean::bridge {
namespace {

// [MIDI 1.0] table III, "Controller Numbers".
constexpr int kEntryCoarse = 6;
constexpr int kEntryFine = kEntryCoarse + kMidiPairs;
constexpr int kNrpnFine = 98;
constexpr int kNrpnCoarse = 99;
constexpr int kRpnFine = 100;
constexpr int kRpnCoarse = 101;
/// NRPN and RPN 127/127 select nothing.
constexpr int kNull = 127 * 128 + 127;

constexpr std::uint8_t kNoteOff = 0x80;
constexpr std::uint8_t kNoteOn = 0x90;
constexpr std::uint8_t kControlChange = 0xB0;
constexpr std::uint8_t kProgramChange = 0xC0;
constexpr std::uint8_t kChannelPressure = 0xD0;
constexpr std::uint8_t kPitchBend = 0xE0;
constexpr std::uint8_t kFirstSystem = 0xF0;
constexpr std::uint8_t kFirstRealTime = 0xF8;

constexpr std::uint8_t kind_of(std::uint8_t status) {
    return status & 0xF0;
}

std::size_t data_bytes(std::uint8_t status) {
    const bool one = kind_of(status) == kProgramChange || kind_of(status) == kChannelPressure;
    return one ? 1 : 2;
}

MidiMessage message(std::uint8_t kind, int channel, int number, int value) {
    return {static_cast<std::uint8_t>(kind | (channel - 1)), static_cast<std::uint8_t>(number),
            static_cast<std::uint8_t>(value)};
}

}  // namespace

void MidiJoiner::Value::become(MidiKind kind, int channel, int number) {
    if (report_.kind == kind && report_.channel == channel && report_.number == number) return;
    *this = Value();
    report_ = {kind, channel, number, 0};
}

std::optional<MidiReport> MidiJoiner::Value::take_coarse(int byte,
                                                         std::optional<Clock::time_point> due) {
    const auto before = take_alone();
    coarse_ = byte;
    due_ = due;
    return before;
}

std::optional<MidiReport> MidiJoiner::Value::take_fine(int byte) {
    has_fine_ = true;
    due_.reset();
    if (!coarse_) return std::nullopt;  // the position is unknown
    report_.value = *coarse_ * 128 + byte;
    return report_;
}

std::optional<MidiReport> MidiJoiner::Value::take_alone() {
    if (!due_) return std::nullopt;
    due_.reset();
    report_.value = *coarse_ * 128;
    return report_;
}

std::optional<MidiReport> MidiJoiner::select(ChannelState& state, MidiKind kind, bool coarse,
                                             int byte) {
    Number& number = kind == MidiKind::nrpn ? state.nrpn : state.rpn;
    (coarse ? number.coarse : number.fine) = byte;
    state.selected = kind;
    return state.entry.take_alone();  // its fine byte can no longer come
}

std::optional<int> MidiJoiner::selected_number(const ChannelState& state) {
    const Number& number = *state.selected == MidiKind::nrpn ? state.nrpn : state.rpn;
    if (!number.coarse || !number.fine) return std::nullopt;
    const int joined = *number.coarse * 128 + *number.fine;
    return joined == kNull ? std::nullopt : std::optional(joined);
}

std::vector<MidiReport> MidiJoiner::take(const MidiReport& report, Clock::time_point now) {
    std::vector<MidiReport> joined;
    if (report.kind != MidiKind::controller) return joined;
    const auto add = [&](const std::optional<MidiReport>& value) {
        if (value) joined.push_back(*value);
    };
    ChannelState& state = channels_[static_cast<std::size_t>(report.channel - 1)];
    const bool is_entry = report.number == kEntryCoarse || report.number == kEntryFine;
    if (is_entry && state.selected) {
        const auto number = selected_number(state);
        if (!number) return joined;
        state.entry.become(*state.selected, report.channel, *number);
        add(report.number == kEntryCoarse ? state.entry.take_coarse(report.value, now + kFineWait)
                                          : state.entry.take_fine(report.value));
    } else if (report.number < 2 * kMidiPairs) {
        const int number = report.number % kMidiPairs;
        Value& pair = state.pairs[static_cast<std::size_t>(number)];
        pair.become(MidiKind::pair, report.channel, number);
        if (report.number < kMidiPairs) {
            add(pair.take_coarse(report.value,
                                 pair.has_fine() ? std::optional(now + kFineWait) : std::nullopt));
        } else {
            add(pair.take_fine(report.value));
        }
    } else if (report.number == kNrpnFine || report.number == kNrpnCoarse) {
        add(select(state, MidiKind::nrpn, report.number == kNrpnCoarse, report.value));
    } else if (report.number == kRpnFine || report.number == kRpnCoarse) {
        add(select(state, MidiKind::rpn, report.number == kRpnCoarse, report.value));
    }
    return joined;
}

template <typename Function>
void MidiJoiner::for_each_value(const Function& function) {
    for (ChannelState& state : channels_) {
        for (Value& pair : state.pairs) function(pair);
        function(state.entry);
    }
}

std::vector<MidiReport> MidiJoiner::advance(Clock::time_point now) {
    std::vector<MidiReport> late;
    for_each_value([&](Value& value) {
        if (!value.due() || *value.due() > now) return;
        if (const auto report = value.take_alone()) late.push_back(*report);
    });
    return late;
}

std::optional<Clock::time_point> MidiJoiner::next() const {
    std::optional<Clock::time_point> earliest;
    const auto compare = [&](const Value& value) {
        if (value.due() && (!earliest || *value.due() < *earliest)) earliest = value.due();
    };
    for (const ChannelState& state : channels_) {
        std::ranges::for_each(state.pairs, compare);
        compare(state.entry);
    }
    return earliest;
}

std::vector<MidiReport> MidiParser::feed(std::span<const std::uint8_t> bytes) {
    std::vector<MidiReport> reports;
    for (const std::uint8_t byte : bytes) {
        if (const auto report = take(byte)) reports.push_back(*report);
    }
    return reports;
}

std::optional<MidiReport> MidiParser::take(std::uint8_t byte) {
    if (byte >= kFirstRealTime) return std::nullopt;
    if (byte >= kNoteOff) {
        status_ = byte < kFirstSystem ? byte : 0;  // a system message ends running status
        count_ = 0;
        return std::nullopt;
    }
    if (status_ == 0) return std::nullopt;
    data_[count_++] = byte;
    if (count_ < data_bytes(status_)) return std::nullopt;
    count_ = 0;
    return report();
}

std::optional<MidiReport> MidiParser::report() const {
    const int channel = (status_ & 0x0F) + 1;
    const auto [first, second] = data_;
    switch (kind_of(status_)) {
        case kNoteOff:
            return MidiReport{MidiKind::note, channel, first, 0};
        case kNoteOn:
            return MidiReport{MidiKind::note, channel, first, second > 0 ? 1 : 0};
        case kControlChange:
            return MidiReport{MidiKind::controller, channel, first, second};
        case kPitchBend:
            return MidiReport{MidiKind::bend, channel, 1, first | second << 7};
        default:
            return std::nullopt;
    }
}

MidiMessage control_change(int channel, int controller, int value) {
    return message(kControlChange, channel, controller, value);
}

MidiMessage note_on(int channel, int note, int velocity) {
    return message(kNoteOn, channel, note, velocity);
}

}  // namespace ocean::bridge
