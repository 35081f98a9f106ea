// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The system's MIDI ports as a source needs them: one input and the output of the same name.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "ocean/internal/bridge/midi_source.hpp"
#include "ocean/internal/bridge/source.hpp"

namespace ocean::bridge {

class MidiPorts {
  public:
    using Receiver = std::function<void(std::span<const std::uint8_t>)>;

    virtual ~MidiPorts() = default;
    /// Returns the names of all inputs. Throws Error if the system has no MIDI.
    virtual std::vector<std::string> inputs() = 0;
    /// Opens the input of that name, and the output of that name if there is one. `receiver` is
    /// called in another thread until close() returns. Returns false if the input has just gone.
    virtual bool open(const std::string& name, Receiver receiver) = 0;
    /// Returns true if the open port has been connected without a break. A port that left and came
    /// back is another port.
    virtual bool is_still_connected() = 0;
    virtual void close() = 0;
    /// Sends bytes to the output if one is open. Does not block.
    virtual void send(std::span<const std::uint8_t> bytes) = 0;
};

/// Returns the ports of this system, by RtMidi. Throws Error unsupported in a build without it.
std::unique_ptr<MidiPorts> system_midi_ports();

/// Returns the source of a MIDI controller on ports that a test can replace. `poll_interval` is the
/// time between two looks at the list of ports.
std::unique_ptr<Source> make_midi_source(std::string id, MidiDevice device,
                                         std::unique_ptr<MidiPorts> ports,
                                         Clock::duration poll_interval);

}  // namespace ocean::bridge
