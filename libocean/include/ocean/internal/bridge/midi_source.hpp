// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// MIDI controllers, by the system's sequencer. Inputs: controllers cc0 .. cc127 (0 .. 127), keys
// and pads n0 .. n127 (0 or 1), the pitch wheel pb1, pairs of a coarse and a fine controller
// pair0 .. pair31, nrpn0 .. nrpn16383 and rpn0 .. rpn16383 (all 0 .. 16383). Outputs (0 .. 127):
// led0 .. led127 by control change, lamp0 .. lamp127 by note on.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "ocean/internal/bridge/source.hpp"

namespace ocean::bridge {

/// The settings of `driver = "midi"`.
struct MidiDevice {
    std::string port;  // part of the port's name, in any case; "" for the first controller
    int channel = 0;   // 1 .. 16; 0 for all
    bool operator==(const MidiDevice&) const = default;
};

/// Returns the channels of a controller with the id `board`, except nrpn and rpn, which are too
/// many to list.
std::vector<Channel> midi_channels(const std::string& board);

/// Makes the source of one controller, which may be plugged in and out at any time. The position of
/// a control is unknown until it is moved. Values of outputs are sent again when the controller
/// connects; at stop() all outputs that were set become 0. Throws Error unsupported in a build
/// without RtMidi.
std::unique_ptr<Source> make_midi_source(const std::string& id, const MidiDevice& device);

}  // namespace ocean::bridge
