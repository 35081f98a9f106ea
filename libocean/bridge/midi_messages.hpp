// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// MIDI 1.0 as bytes: the messages of controllers, keys and the pitch wheel, and those that light
// lamps; and values of 14 bits that it sends as two controllers: pairs (a coarse controller 0 .. 31
// and its fine one, 32 more), and NRPN and RPN, whose number is selected by two controllers and
// whose value is the pair 6 and 38. Independent of the system.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "ocean/internal/bridge/source.hpp"

namespace ocean::bridge {

inline constexpr int kMidiNumbers = 128;  // controllers, or notes
inline constexpr int kMidiMax = 127;      // max value of a controller
inline constexpr int kMidiPairs = 32;     // coarse controllers 0 .. 31, each with a fine one
inline constexpr int kMidiMax14 = 16383;  // max value of 14 bits; the pitch wheel rests at 8192

/// The kinds pair, nrpn and rpn are joined from controllers: see MidiJoiner.
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

/// Joins the bytes of each MIDI channel. A coarse byte waits for its fine byte, since a value of
/// the coarse byte alone would jump; a fine byte that does not come in time is 0 [MIDI 1.0,
/// "Control Change", p. 12]. A fine byte without a new coarse byte is a small step from the last
/// coarse byte. Two controllers become a pair at their first fine byte, so a controller of 7 bits
/// never does.
class MidiJoiner {
  public:
    /// The time to wait for a fine byte. Two messages take 2 ms on the slowest cable.
    static constexpr auto kFineWait = std::chrono::milliseconds(10);

    /// Returns the complete values that a report makes, in order.
    std::vector<MidiReport> take(const MidiReport& report, Clock::time_point now);
    /// Returns the values whose fine byte has not come in time.
    std::vector<MidiReport> advance(Clock::time_point now);
    /// Returns when to call advance(), or nothing while no value waits.
    std::optional<Clock::time_point> next() const;

  private:
    class Value {
      public:
        /// Assigns a number, and forgets the bytes if it is another one.
        void become(MidiKind kind, int channel, int number);
        /// Stores a coarse byte. Returns the value before it if that still waits.
        std::optional<MidiReport> take_coarse(int byte, std::optional<Clock::time_point> due);
        /// Returns the value with this fine byte, or nothing before the first coarse byte.
        std::optional<MidiReport> take_fine(int byte);
        /// Returns a waiting value with the fine byte 0, or nothing if none waits.
        std::optional<MidiReport> take_alone();
        bool has_fine() const { return has_fine_; }
        std::optional<Clock::time_point> due() const { return due_; }

      private:
        MidiReport report_;
        std::optional<int> coarse_;
        std::optional<Clock::time_point> due_;
        bool has_fine_ = false;
    };
    struct Number {
        std::optional<int> coarse;
        std::optional<int> fine;
    };
    struct ChannelState {
        std::array<Value, kMidiPairs> pairs;
        Value entry;  // of the selected parameter
        Number nrpn;
        Number rpn;
        std::optional<MidiKind> selected;
    };
    std::optional<MidiReport> select(ChannelState& state, MidiKind kind, bool coarse, int byte);
    static std::optional<int> selected_number(const ChannelState& state);
    template <typename Function>
    void for_each_value(const Function& function);

    std::array<ChannelState, 16> channels_;
};

}  // namespace ocean::bridge
