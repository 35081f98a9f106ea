// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Open Sound Control 1.0 as bytes: a packet to its messages, messages to packets, addresses to
// names of values. No sockets and no state. Only osc_message.cpp uses liblo.
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

// Limits of a packet, which must not delay other clients. A larger one is refused.
inline constexpr std::size_t kMaxOscAddressBytes = 256;
inline constexpr std::size_t kMaxOscTextBytes = 1024;
inline constexpr std::size_t kMaxOscArguments = 16;
inline constexpr std::size_t kMaxOscMessages = 256;  // per packet
inline constexpr int kMaxOscBundleDepth = 8;

/// Throws Error unsupported in a build without liblo, as parse_osc_packet, osc_packet and
/// osc_bundles do.
void require_osc();

/// The parts of a packet.
struct OscPacket {
    std::vector<OscMessage> messages;   // in order, also those of nested bundles
    std::vector<std::string> left_out;  // reason for each element of a bundle that was left out
};

/// Parses a message or a bundle. A bundle gives the size of each element, so an element that cannot
/// be read, such as a message for another program with types other than i, h, f, d, s, S, T, F, is
/// left out alone. Throws Error invalid_value for a packet that is one such message, whose outer
/// bundle has wrong sizes, or that has too many elements.
OscPacket parse_osc_packet(std::string_view bytes);
/// Returns the bytes of a message. A whole number has the type `i`, or `h` beyond 32 bits; other
/// arguments have their own types.
std::string osc_packet(const OscMessage& message);
/// Returns the messages as bundles with the time "immediately". Each bundle fits into one packet of
/// an Ethernet, unless a single message is larger.
std::vector<std::string> osc_bundles(std::span<const OscMessage> messages);

/// Returns the argument as SET reads it: "14", "0.1", "jonswap".
std::string osc_text(const OscArgument& argument);
/// Returns "app.pause" for "/ocean/app/pause" and "/ocean/app.pause", and nothing for an address
/// that does not begin with /ocean/.
std::optional<std::string> osc_name(std::string_view address);
/// Returns "/ocean/waves/0/wind_speed" for "waves.0.wind_speed".
std::string osc_address(std::string_view name);

}  // namespace ocean::bridge
