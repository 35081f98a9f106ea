// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "midi_messages.hpp"

namespace ocean::bridge {
namespace {

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
