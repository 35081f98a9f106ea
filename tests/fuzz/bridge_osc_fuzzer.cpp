// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Any bytes as a packet of Open Sound Control: refused as a whole, or messages within the limits
// that are the same after they were written, one by one and as bundles, and reasons for the others.
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/error.hpp"
#include "osc_message.hpp"
#include "require.hpp"

namespace {

using namespace ocean;
using namespace ocean::bridge;
using ocean::fuzz::require;

/// By their bytes: a NaN is no other after it was written, though it is not equal to itself.
void require_same(const OscMessage& message, const OscMessage& written) {
    require(osc_packet(message) == osc_packet(written));
}

void check(const OscMessage& message) {
    require(message.address.starts_with('/') && message.address.size() <= kMaxOscAddressBytes);
    require(message.arguments.size() <= kMaxOscArguments);
    for (const OscArgument& argument : message.arguments) {
        require(osc_text(argument).size() <= kMaxOscTextBytes);
    }
    if (const auto name = osc_name(message.address)) {
        require(osc_name(osc_address(*name)) == name);
    }
    const auto again = parse_osc_packet(osc_packet(message)).messages;
    require(again.size() == 1);
    require_same(message, again[0]);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    OscPacket packet;
    try {
        packet = parse_osc_packet({reinterpret_cast<const char*>(data), size});
    } catch (const Error& error) {
        require(error.kind() == ErrorKind::invalid_value);
        return 0;
    }
    const std::vector<OscMessage>& messages = packet.messages;
    require(messages.size() + packet.left_out.size() <= kMaxOscMessages);
    std::size_t count = 0;
    for (const OscMessage& message : messages) check(message);
    for (const std::string& bundle : osc_bundles(messages)) {
        for (const OscMessage& message : parse_osc_packet(bundle).messages) {
            require_same(messages.at(count++), message);
        }
    }
    require(count == messages.size());
    return 0;
}
