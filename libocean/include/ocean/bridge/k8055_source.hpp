// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Velleman's USB boards K8055, K8055N and VM110, by libusb: knobs a1, a2 (0 .. 255), buttons d1 ..
// d5, counters c1, c2 (0 .. 65535); lamps o1 .. o8 and voltages dac1, dac2 (0 .. 255).
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "ocean/bridge/map_file.hpp"
#include "ocean/bridge/source.hpp"

namespace ocean::bridge {

/// Of such a board named `board`, which the dummy board has too.
std::vector<Channel> k8055_channels(const std::string& board);

/// A board, and the address of its jumpers.
struct K8055Board {
    std::string id;
    K8055Device device;
};

/// Boards may come and go at any time. What an output was told holds for a board that is not there,
/// and is sent to it when it comes; at the end all outputs are put out. Throws Error unsupported if
/// the library was built without libusb.
std::unique_ptr<Source> make_k8055_source(std::vector<K8055Board> boards);

}  // namespace ocean::bridge
