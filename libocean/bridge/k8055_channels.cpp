// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "ocean/internal/bridge/k8055_source.hpp"

namespace ocean::bridge {

std::vector<Channel> k8055_channels(const std::string& board) {
    std::vector<Channel> channels;
    const auto add = [&](const std::string& letters, int count, double max, bool output) {
        for (int i = 1; i <= count; ++i) {
            channels.push_back({board + "/" + letters + std::to_string(i), 0.0, max, output});
        }
    };
    add("a", 2, 255.0, false);
    add("d", 5, 1.0, false);
    add("c", 2, 65535.0, false);
    add("o", 8, 1.0, true);
    add("dac", 2, 255.0, true);
    return channels;
}

}  // namespace ocean::bridge
