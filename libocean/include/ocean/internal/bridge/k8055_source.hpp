// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Velleman's USB boards K8055, K8055N and VM110, by libusb. Inputs: knobs a1, a2 (0 .. 255),
// buttons d1 .. d5 (0 or 1), counters c1, c2 (0 .. 65535). Outputs: lamps o1 .. o8 (0 or 1),
// voltages dac1, dac2 (0 .. 255).
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "ocean/internal/bridge/source.hpp"

namespace ocean::bridge {

/// The settings of `driver = "k8055"`.
struct K8055Device {
    int address = 0;  // 0 .. 3, as the board's jumpers set it
    bool operator==(const K8055Device&) const = default;
};
inline constexpr int kK8055Addresses = 4;

/// Returns the channels of a board with the id `board`, also for the dummy board.
std::vector<Channel> k8055_channels(const std::string& board);

struct K8055Board {
    std::string id;
    K8055Device device;
};

/// Makes one source for all boards, which may be plugged in and out at any time. Values of outputs
/// are kept while a board is away and sent when it connects; at stop() all outputs are set to 0.
/// Throws Error unsupported in a build without libusb.
std::unique_ptr<Source> make_k8055_source(std::vector<K8055Board> boards);

}  // namespace ocean::bridge
