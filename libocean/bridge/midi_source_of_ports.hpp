// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A MIDI controller on ports that a test can stand in for.
#pragma once

#include <memory>
#include <string>

#include "midi_ports.hpp"
#include "ocean/bridge/map_file.hpp"
#include "ocean/bridge/source.hpp"

namespace ocean::bridge {

/// `look` is how often the list of ports is looked at.
std::unique_ptr<Source> make_midi_source(std::string id, MidiDevice device,
                                         std::unique_ptr<MidiPorts> ports, Clock::duration look);

}  // namespace ocean::bridge
