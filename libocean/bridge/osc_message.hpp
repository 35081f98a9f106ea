// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Open Sound Control 1.0 as bytes: a packet to its messages, messages to packets, addresses to
// names of values. No sockets and no state. The one place that knows liblo.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace ocean::bridge {

using OscArgument = std::variant<std::int64_t, float, double, bool, std::string>;

struct OscMessage {
    std::string address;  // "/ocean/wind_speed"
    std::vector<OscArgument> arguments;
};

// What is larger is refused: a packet must not keep other clients waiting.
inline constexpr std::size_t kLongestOscAddress = 256;  // bytes
inline constexpr std::size_t kLongestOscText = 1024;
inline constexpr std::size_t kMostOscArguments = 16;
inline constexpr std::size_t kMostOscMessages = 256;  // of a packet
inline constexpr int kDeepestOscBundle = 8;

/// Throws Error unsupported in a build without liblo, as all that follows may.
void require_osc();

/// A packet that was read.
struct OscPacket {
    std::vector<OscMessage> messages;   // in their order, also those of bundles in bundles
    std::vector<std::string> left_out;  // why, for each element of a bundle that cannot be read
};

/// Reads a message or a bundle. A bundle says how long each of its elements is: one that cannot be
/// read, such as a message for another program with types that are not of i, h, f, d, s, S, T, F,
/// is left out alone. Throws Error invalid_value for a packet that is no more than one such
/// message, whose own bundle has sizes that do not fit, or which has too many elements.
OscPacket parse_osc_packet(std::string_view bytes);
/// Whole numbers are `i`, or `h` where 32 bits are too few; the rest is as its type says.
std::string osc_packet(const OscMessage& message);
/// As bundles that count at once, in as few packets as networks carry in one piece.
std::vector<std::string> osc_bundles(std::span<const OscMessage> messages);

/// What SET would be told: "14", "0.1", "jonswap".
std::string osc_text(const OscArgument& argument);
/// "/ocean/app/pause" and "/ocean/app.pause" are "app.pause"; nothing of other addresses.
std::optional<std::string> osc_name(std::string_view address);
/// "/ocean/waves/0/wind_speed".
std::string osc_address(std::string_view name);

}  // namespace ocean::bridge
