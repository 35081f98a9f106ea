// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The source of a MIDI controller on ports that a test can replace.
#pragma once

#include <memory>
#include <string>

#include "midi_ports.hpp"
#include "ocean/internal/bridge/midi_source.hpp"
#include "ocean/internal/bridge/source.hpp"

namespace ocean::bridge {

/// `poll_interval` is the time between two looks at the list of ports.
std::unique_ptr<Source> make_midi_source(std::string id, MidiDevice device,
                                         std::unique_ptr<MidiPorts> ports,
                                         Clock::duration poll_interval);

}  // namespace ocean::bridge
