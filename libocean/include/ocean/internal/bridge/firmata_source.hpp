// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Arduinos with StandardFirmata at a serial line. Inputs: a0 .. a15 (0 .. 1023), d0 .. d127 (0 or
// 1). Outputs: o0 .. o127 (0 or 1), pwm0 .. pwm127 (0 .. 255). A board has those channels whose
// pins its settings name.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "ocean/internal/bridge/source.hpp"

namespace ocean::bridge {

/// The settings of `driver = "firmata"`.
struct FirmataDevice {
    std::string port;  // "/dev/ttyACM0"; required
    int baud = 57600;
    std::vector<int> analog;   // analog inputs, 0 for A0
    std::vector<int> inputs;   // digital pins; so are all lists below
    std::vector<int> pullups;  // inputs with the chip's pull-up resistor: 1 while not wired
    std::vector<int> outputs;
    std::vector<int> pwm;
    bool operator==(const FirmataDevice&) const = default;
};
inline constexpr int kFirmataAnalogs = 16;
inline constexpr int kFirmataPins = 128;
inline constexpr std::array kFirmataBauds = {9600, 19200, 38400, 57600, 115200, 230400};

/// Returns the channels of a board with the id `board`: first the inputs, then the outputs.
std::vector<Channel> firmata_channels(const std::string& board, const FirmataDevice& device);

/// Makes the source of one board, which may be plugged in and out at any time. Values of outputs
/// are kept while the board is away and sent when it connects; at stop() all outputs are set to 0.
std::unique_ptr<Source> make_firmata_source(const std::string& id, const FirmataDevice& device);

}  // namespace ocean::bridge
