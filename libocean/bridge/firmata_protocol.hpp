// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Firmata 2.5, the serial protocol of Arduinos, as bytes: github.com/firmata/protocol. Nothing of a
// system here.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <vector>

namespace ocean::bridge {

enum class FirmataKind {
    analog,    // number: analog input, 0 for A0; value: 14 bits
    digital,   // number: port; value: a bit for each of its 8 pins
    version,   // number: major, value: minor
    firmware,  // the board's program has just started
};

struct FirmataReport {
    FirmataKind kind = FirmataKind::version;
    int number = 0;
    int value = 0;

    bool operator==(const FirmataReport&) const = default;
};

inline constexpr int kFirmataPortPins = 8;

/// Parses a stream in pieces of any size and skips bytes that are not of the protocol.
class FirmataParser {
  public:
    std::vector<FirmataReport> feed(std::span<const std::uint8_t> bytes);

  private:
    std::optional<FirmataReport> take(std::uint8_t byte);
    std::optional<FirmataReport> begin(std::uint8_t command);
    FirmataReport report() const;

    std::uint8_t command_ = 0;  // 0: data bytes are skipped
    std::array<std::uint8_t, 2> data_{};
    std::size_t count_ = 0;
};

enum class PinMode : std::uint8_t { input = 0x00, output = 0x01, pwm = 0x03, pullup = 0x0B };

/// Collects messages for the board.
class FirmataWriter {
  public:
    void request_version();
    void set_pin_mode(int pin, PinMode mode);
    void set_sampling_interval(int milliseconds);
    void report_analog(int input);
    void report_digital(int port);
    void write_digital(int pin, bool on);
    /// `value` is 0 .. 255.
    void write_pwm(int pin, int value);

    std::span<const std::uint8_t> bytes() const { return bytes_; }
    bool empty() const { return bytes_.empty(); }
    /// Removes the first `count` bytes, which have been sent.
    void drop(std::size_t count);

  private:
    void add(std::initializer_list<int> bytes);

    std::vector<std::uint8_t> bytes_;
};

}  // namespace ocean::bridge
