// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Values of 14 bits that MIDI 1.0 sends as two controllers, between the parser and the source:
// pairs (a coarse controller 0 .. 31 and its fine one, 32 more), and NRPN and RPN, whose number is
// selected by two controllers and whose value is the pair 6 and 38.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "midi_messages.hpp"
#include "ocean/bridge/source.hpp"

namespace ocean::bridge {

/// Joins the bytes of each MIDI channel. The coarse byte alone is never told, or the value would
/// jump between the two: it waits for the fine one, which is 0 where it does not come in time
/// [MIDI 1.0, "Control Change", p. 12]. A fine byte alone is a small step from the coarse byte of
/// before. A pair is one from its first fine byte on, so that a controller of 7 bits is none.
class MidiJoiner {
  public:
    /// Both bytes of a message take 2 ms on the slowest cable.
    static constexpr auto kFineWait = std::chrono::milliseconds(10);

    /// Returns the values that a report completes, each a whole one. Their order counts.
    std::vector<MidiReport> take(const MidiReport& report, Clock::time_point now);
    /// Returns the values whose fine byte has not come in time.
    std::vector<MidiReport> advance(Clock::time_point now);
    /// When to advance next; nothing while no value waits.
    std::optional<Clock::time_point> next() const;

  private:
    class Value {
      public:
        /// Forgets the bytes of another number.
        void become(MidiKind kind, int channel, int number);
        /// Returns the value of before, if that still waits.
        std::optional<MidiReport> take_coarse(int byte, std::optional<Clock::time_point> due);
        std::optional<MidiReport> take_fine(int byte);
        /// Returns the value without its fine byte, if it waits.
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
        Value entry;  // of the parameter that is selected
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
