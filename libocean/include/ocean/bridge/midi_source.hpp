// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// MIDI controllers, by the system's sequencer: controllers cc0 .. cc127 (0 .. 127), keys and pads
// n0 .. n127 (0 or 1), the pitch wheel pb1, pairs of a coarse and a fine controller pair0 ..
// pair31, nrpn0 .. nrpn16383 and rpn0 .. rpn16383 (all 0 .. 16383); lamps led0 .. led127, told by
// control change, and lamp0 .. lamp127, told by note on (0 .. 127).
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "ocean/bridge/map_file.hpp"
#include "ocean/bridge/source.hpp"

namespace ocean::bridge {

/// Returns those of a controller named `board`, but for nrpn and rpn, which are too many to list.
std::vector<Channel> midi_channels(const std::string& board);

/// The controller may come and go at any time. Where its controls are is not known before they are
/// moved. What an output was told is sent again when it comes back; at the end all that were told
/// are put out. Throws Error unsupported if the library was built without RtMidi.
std::unique_ptr<Source> make_midi_source(const std::string& id, const MidiDevice& device);

}  // namespace ocean::bridge
