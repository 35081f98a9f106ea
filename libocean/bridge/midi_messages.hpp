// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// MIDI 1.0 as bytes: what controllers, keys and the pitch wheel say, and what lights their lamps.
// Nothing of a system here.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace ocean::bridge {

inline constexpr int kMidiNumbers = 128;   // of controllers and of notes
inline constexpr int kMidiHighest = 127;   // value of a controller
inline constexpr int kMidiPairs = 32;      // coarse controllers 0 .. 31, each with a fine one
inline constexpr int kMidiWidest = 16383;  // 14 bits; of the pitch wheel 8192 is the middle

/// The last three are joined from controllers (midi_joiner.hpp).
enum class MidiKind { controller, note, bend, pair, nrpn, rpn };

/// A message of a channel, 1 .. 16. A note's value is 1 while it is held.
struct MidiReport {
    MidiKind kind = MidiKind::controller;
    int channel = 1;
    int number = 0;
    int value = 0;

    bool operator==(const MidiReport&) const = default;
};

/// Takes a stream that may be cut anywhere. Running status holds; real-time bytes may stand
/// anywhere and count for nothing; of system messages and of what began before the stream nothing
/// is left.
class MidiParser {
  public:
    std::vector<MidiReport> feed(std::span<const std::uint8_t> bytes);

  private:
    std::optional<MidiReport> take(std::uint8_t byte);
    std::optional<MidiReport> report() const;

    std::uint8_t status_ = 0;  // 0: data bytes belong to nothing
    std::array<std::uint8_t, 2> data_{};
    std::size_t count_ = 0;
};

using MidiMessage = std::array<std::uint8_t, 3>;

MidiMessage control_change(int channel, int controller, int value);
/// A velocity of 0 ends the note.
MidiMessage note_on(int channel, int note, int velocity);

}  // namespace ocean::bridge
