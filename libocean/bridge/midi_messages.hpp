// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// MIDI 1.0 as bytes: the messages of controllers, keys and the pitch wheel, and those that light
// lamps. Independent of the system.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace ocean::bridge {

inline constexpr int kMidiNumbers = 128;  // controllers, or notes
inline constexpr int kMidiMax = 127;      // max value of a controller
inline constexpr int kMidiPairs = 32;     // coarse controllers 0 .. 31, each with a fine one
inline constexpr int kMidiMax14 = 16383;  // max value of 14 bits; the pitch wheel rests at 8192

/// The kinds pair, nrpn and rpn are joined from controllers (midi_joiner.hpp).
enum class MidiKind { controller, note, bend, pair, nrpn, rpn };

/// A message of a channel, 1 .. 16. The value of a note is 1 while the key is held, else 0.
struct MidiReport {
    MidiKind kind = MidiKind::controller;
    int channel = 1;
    int number = 0;
    int value = 0;

    bool operator==(const MidiReport&) const = default;
};

/// Parses a stream in pieces of any size. It keeps the running status, ignores real-time bytes
/// anywhere, and skips system messages and a message that began before the stream.
class MidiParser {
  public:
    std::vector<MidiReport> feed(std::span<const std::uint8_t> bytes);

  private:
    std::optional<MidiReport> take(std::uint8_t byte);
    std::optional<MidiReport> report() const;

    std::uint8_t status_ = 0;  // 0: data bytes are skipped
    std::array<std::uint8_t, 2> data_{};
    std::size_t count_ = 0;
};

using MidiMessage = std::array<std::uint8_t, 3>;

MidiMessage control_change(int channel, int controller, int value);
/// Returns a note on; the velocity 0 ends the note.
MidiMessage note_on(int channel, int note, int velocity);

}  // namespace ocean::bridge
