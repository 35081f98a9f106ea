// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The system's MIDI ports as a source needs them: one input and the output beside it.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace ocean::bridge {

class MidiPorts {
  public:
    using Receiver = std::function<void(std::span<const std::uint8_t>)>;

    virtual ~MidiPorts() = default;
    /// Names of the inputs that there are now. Throws Error if the system has no MIDI.
    virtual std::vector<std::string> inputs() = 0;
    /// The input of that name, and the output if it has one; false if it has just gone. Bytes come
    /// from now on, in another thread, until close() returns.
    virtual bool open(const std::string& name, Receiver receiver) = 0;
    /// Whether the open port was there all the time; one that left and is back is another.
    virtual bool is_still_there() = 0;
    virtual void close() = 0;
    /// To the output, if there is one; does not wait.
    virtual void send(std::span<const std::uint8_t> bytes) = 0;
};

/// Of this system, by RtMidi. Throws Error unsupported if the library was built without it.
std::unique_ptr<MidiPorts> system_midi_ports();

}  // namespace ocean::bridge
