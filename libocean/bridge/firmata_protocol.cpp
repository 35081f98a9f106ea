// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "firmata_protocol.hpp"

namespace ocean::bridge {
namespace {

constexpr std::uint8_t kDigital = 0x90;        // | port
constexpr std::uint8_t kReportAnalog = 0xC0;   // | input
constexpr std::uint8_t kReportDigital = 0xD0;  // | port
constexpr std::uint8_t kAnalog = 0xE0;         // | input, or pin on the way to the board
constexpr std::uint8_t kSysex = 0xF0;
constexpr std::uint8_t kSetPinMode = 0xF4;
constexpr std::uint8_t kSetPin = 0xF5;
constexpr std::uint8_t kSysexEnd = 0xF7;
constexpr std::uint8_t kVersion = 0xF9;
// Kinds of sysex.
constexpr std::uint8_t kExtendedAnalog = 0x6F;
constexpr std::uint8_t kFirmware = 0x79;
constexpr std::uint8_t kSetSamplingInterval = 0x7A;

constexpr int kShortPins = 16;  // pins that a command byte can name

/// Returns the command without the number in its low bits.
constexpr std::uint8_t kind_of(std::uint8_t command) {
    return command < kSysex ? command & 0xF0 : command;
}

constexpr int low(int value) {
    return value & 0x7F;
}
constexpr int high(int value) {
    return value >> 7 & 0x7F;
}

}  // namespace

std::vector<FirmataReport> FirmataParser::feed(std::span<const std::uint8_t> bytes) {
    std::vector<FirmataReport> reports;
    for (const std::uint8_t byte : bytes) {
        if (const auto report = take(byte)) reports.push_back(*report);
    }
    return reports;
}

std::optional<FirmataReport> FirmataParser::take(std::uint8_t byte) {
    if (byte >= 0x80) return begin(byte);
    if (command_ == 0) return std::nullopt;
    if (count_ < data_.size()) data_[count_++] = byte;
    if (command_ == kSysex || count_ < data_.size()) return std::nullopt;
    const FirmataReport whole = report();
    command_ = 0;
    return whole;
}

std::optional<FirmataReport> FirmataParser::begin(std::uint8_t command) {
    const bool firmware =
        command == kSysexEnd && command_ == kSysex && count_ > 0 && data_.front() == kFirmware;
    const std::uint8_t kind = kind_of(command);
    const bool known = kind == kDigital || kind == kAnalog || kind == kVersion || kind == kSysex;
    command_ = known ? command : 0;
    count_ = 0;
    if (firmware) return FirmataReport{FirmataKind::firmware, 0, 0};
    return std::nullopt;
}

FirmataReport FirmataParser::report() const {
    const auto [first, second] = data_;
    if (command_ == kVersion) return {FirmataKind::version, first, second};
    const FirmataKind kind =
        kind_of(command_) == kAnalog ? FirmataKind::analog : FirmataKind::digital;
    return {kind, command_ & 0x0F, first | second << 7};
}

void FirmataWriter::request_version() {
    add({kVersion});
}

void FirmataWriter::set_pin_mode(int pin, PinMode mode) {
    add({kSetPinMode, pin, static_cast<int>(mode)});
}

void FirmataWriter::set_sampling_interval(int milliseconds) {
    add({kSysex, kSetSamplingInterval, low(milliseconds), high(milliseconds), kSysexEnd});
}

void FirmataWriter::report_analog(int input) {
    add({kReportAnalog | input, 1});
}

void FirmataWriter::report_digital(int port) {
    add({kReportDigital | port, 1});
}

void FirmataWriter::write_digital(int pin, bool on) {
    add({kSetPin, pin, on ? 1 : 0});
}

void FirmataWriter::write_pwm(int pin, int value) {
    if (pin < kShortPins) {
        add({kAnalog | pin, low(value), high(value)});
    } else {
        add({kSysex, kExtendedAnalog, pin, low(value), high(value), kSysexEnd});
    }
}

void FirmataWriter::drop(std::size_t count) {
    bytes_.erase(bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>(count));
}

void FirmataWriter::add(std::initializer_list<int> bytes) {
    for (const int byte : bytes) bytes_.push_back(static_cast<std::uint8_t>(byte));
}

}  // namespace ocean::bridge
