// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The eight bytes that a K8055 sends and the eight that it accepts, as libk8055, pyopen8055 and the
// kernel's vmk80xx agree:
//   in   digital inputs, address, A1, A2, counter 1 (two bytes, low first), counter 2
//   out  command 5, lamps, DAC1, DAC2, four bytes of other commands
// K8055N and VM110N use the same bytes unless they are switched to another mode.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

namespace ocean::bridge {

inline constexpr std::size_t kK8055Bytes = 8;

/// The inputs in the order of k8055_channels(): a1, a2, d1 .. d5, c1, c2.
using K8055Inputs = std::array<double, 9>;
/// The outputs, which follow there: o1 .. o8 (0 or 1), dac1, dac2 (0 .. 255).
using K8055Outputs = std::array<std::uint8_t, 10>;

/// Returns nothing for a report of another length. Ignores the address in the report, which the
/// board's USB descriptor has given.
std::optional<K8055Inputs> decode_k8055_report(std::span<const std::uint8_t> bytes);
std::array<std::uint8_t, kK8055Bytes> encode_k8055_outputs(const K8055Outputs& outputs);

}  // namespace ocean::bridge
