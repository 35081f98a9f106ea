// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "k8055_report.hpp"

#include "ocean/internal/bridge/k8055_source.hpp"

namespace ocean::bridge {

std::optional<K8055Inputs> decode_k8055_report(std::span<const std::uint8_t> bytes) {
    if (bytes.size() != kK8055Bytes) return std::nullopt;
    constexpr std::array<int, 5> kDigitalBits = {4, 5, 0, 6, 7};  // bits of I1 .. I5
    K8055Inputs inputs{};
    std::size_t next = 0;
    inputs[next++] = bytes[2];
    inputs[next++] = bytes[3];
    for (const int bit : kDigitalBits) inputs[next++] = bytes[0] >> bit & 1;
    inputs[next++] = bytes[4] | bytes[5] << 8;
    inputs[next++] = bytes[6] | bytes[7] << 8;
    return inputs;
}

std::array<std::uint8_t, kK8055Bytes> encode_k8055_outputs(const K8055Outputs& outputs) {
    constexpr std::uint8_t kWriteOutputs = 5;
    constexpr std::size_t kLamps = 8;
    unsigned lamps = 0;
    for (std::size_t i = 0; i < kLamps; ++i) lamps |= (outputs[i] != 0 ? 1U : 0U) << i;
    return {kWriteOutputs, static_cast<std::uint8_t>(lamps), outputs[kLamps], outputs[kLamps + 1]};
}

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
