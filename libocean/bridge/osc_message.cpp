// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "osc_message.hpp"

#include <algorithm>

#include "ocean/error.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/text.hpp"

#ifdef OCEAN_HAVE_LIBLO
#include <lo/lo_lowlevel.h>

#include <cstring>
#include <memory>
#endif

namespace ocean::bridge {
namespace {

constexpr std::string_view kPrefix = "/ocean/";

}  // namespace

std::string osc_text(const OscArgument& argument) {
    if (const auto* text = std::get_if<std::string>(&argument)) return *text;
    if (const auto* whole = std::get_if<std::int64_t>(&argument)) return std::to_string(*whole);
    if (const auto* yes = std::get_if<bool>(&argument)) return *yes ? "1" : "0";
    if (const auto* number = std::get_if<double>(&argument)) return plain_text(*number);
    // A sender of 0.1f means 0.1, not the double with the same value.
    const std::string digits = shortest_text(std::get<float>(argument));
    const auto number = text::parse_number(digits);
    return number ? plain_text(*number) : digits;
}

std::optional<std::string> osc_name(std::string_view address) {
    if (!address.starts_with(kPrefix)) return std::nullopt;
    std::string name(address.substr(kPrefix.size()));
    std::ranges::replace(name, '/', '.');
    return name;
}

std::string osc_address(std::string_view name) {
    std::string address = std::string(kPrefix) + std::string(name);
    std::ranges::replace(address, '.', '/');
    return address;
}

#ifdef OCEAN_HAVE_LIBLO
namespace {

constexpr std::string_view kBundleTag{"#bundle\0", 8};
constexpr std::string_view kImmediately{"\0\0\0\0\0\0\0\1", 8};
constexpr std::size_t kBundleHead = kBundleTag.size() + kImmediately.size();
/// Ethernet's 1500 bytes minus the headers of IPv6 and UDP, with a reserve for tunnels.
constexpr std::size_t kMaxBundleBytes = 1400;

struct FreeMessage {
    void operator()(lo_message message) const { lo_message_free(message); }
};
using Message = std::unique_ptr<void, FreeMessage>;

Error refused_message(const std::string& reason) {
    return Error(ErrorKind::invalid_value, reason);
}

/// Returns the type tags of a message, which follow its address. liblo 0.31 reads the length of a
/// blob without a check that four bytes are left (lo_validate_blob), so messages with types that
/// are not supported never reach it. Throws Error for them.
std::string_view checked_types(const std::string& address, std::string_view bytes) {
    constexpr std::string_view kTaken = "ihfdsSTF";
    const std::string_view types = bytes.substr(0, bytes.find('\0'));
    if (!types.starts_with(',')) {
        throw refused_message(address + ": the types of its arguments are missing");
    }
    if (types.find_first_not_of(kTaken, 1) != std::string_view::npos) {
        throw refused_message(address + ": its arguments have the types " +
                              text::printable(types.substr(1), kMaxOscArguments) +
                              "; allowed: i, h, f, d, s, S, T, F");
    }
    if (types.size() > 1 + kMaxOscArguments) {
        throw refused_message(address + ": it has too many arguments");
    }
    return types.substr(1);
}

/// Copies an argument: it is aligned to four bytes, a lo_arg may need eight.
template <typename Value>
Value read(const lo_arg* argument) {
    Value value;
    std::memcpy(&value, argument, sizeof value);
    return value;
}

OscArgument argument_of(char type, const lo_arg* argument) {
    switch (type) {
        case LO_INT32:
            return std::int64_t{read<std::int32_t>(argument)};
        case LO_INT64:
            return read<std::int64_t>(argument);
        case LO_FLOAT:
            return read<float>(argument);
        case LO_DOUBLE:
            return read<double>(argument);
        case LO_TRUE:
        case LO_FALSE:
            return type == LO_TRUE;
        default: {
            std::string text(reinterpret_cast<const char*>(argument));
            if (text.size() > kMaxOscTextBytes) throw refused_message("its text is too long");
            return text;
        }
    }
}

OscMessage parse_message(std::string_view bytes) {
    const std::size_t end = bytes.find('\0');
    if (!bytes.starts_with('/') || end == std::string_view::npos || end > kMaxOscAddressBytes) {
        throw refused_message("not a message of OSC: " + text::printable(bytes.substr(0, end)));
    }
    OscMessage message{std::string(bytes.substr(0, end)), {}};
    const std::string_view rest = bytes.substr(std::min(end / 4 * 4 + 4, bytes.size()));
    if (rest.empty()) return message;  // old senders omit the types if there are no arguments
    const std::string_view types = checked_types(message.address, rest);
    std::string copy(bytes);
    const Message parsed(lo_message_deserialise(copy.data(), copy.size(), nullptr));
    if (!parsed) throw refused_message(message.address + ": its bytes do not fit its types");
    lo_arg* const* arguments = lo_message_get_argv(parsed.get());
    for (const char type : types) message.arguments.push_back(argument_of(type, *arguments++));
    return message;
}

std::size_t take_size(std::string_view& bytes) {
    std::size_t size = 0;
    for (const char byte : bytes.substr(0, 4)) size = size << 8 | static_cast<unsigned char>(byte);
    bytes.remove_prefix(std::min<std::size_t>(4, bytes.size()));
    if (size > bytes.size() || size % 4 != 0) throw refused_message("a bundle's sizes do not fit");
    return size;
}

/// Returns the elements of a bundle by their sizes, without a look at their content.
std::vector<std::string_view> elements_of(std::string_view bundle) {
    if (bundle.size() < kBundleHead) throw refused_message("a bundle ends within its time tag");
    bundle.remove_prefix(kBundleHead);
    std::vector<std::string_view> elements;
    while (!bundle.empty()) {
        const std::size_t size = take_size(bundle);
        elements.push_back(bundle.substr(0, size));
        bundle.remove_prefix(size);
    }
    return elements;
}

std::string size_bytes(std::size_t size) {
    std::string bytes;
    for (const int shift : {24, 16, 8, 0}) bytes += static_cast<char>(size >> shift & 0xFF);
    return bytes;
}

std::size_t size_of(const OscPacket& packet) {
    return packet.messages.size() + packet.left_out.size();
}

/// Adds a message, or the readable elements of a bundle. Stops at one element more than allowed.
void parse_element(std::string_view bytes, int depth, OscPacket& packet) {
    if (!bytes.starts_with(kBundleTag)) {
        packet.messages.push_back(parse_message(bytes));
        return;
    }
    if (depth == kMaxOscBundleDepth) throw refused_message("its bundles are nested too deeply");
    for (const std::string_view element : elements_of(bytes)) {
        if (size_of(packet) > kMaxOscMessages) return;
        try {
            parse_element(element, depth + 1, packet);
        } catch (const Error& error) {
            packet.left_out.emplace_back(error.what());
        }
    }
}

void add(lo_message message, const OscArgument& argument) {
    if (const auto* whole = std::get_if<std::int64_t>(&argument)) {
        const auto narrow = static_cast<std::int32_t>(*whole);
        if (narrow == *whole) {
            lo_message_add_int32(message, narrow);
        } else {
            lo_message_add_int64(message, *whole);
        }
    } else if (const auto* yes = std::get_if<bool>(&argument)) {
        *yes ? lo_message_add_true(message) : lo_message_add_false(message);
    } else if (const auto* single = std::get_if<float>(&argument)) {
        lo_message_add_float(message, *single);
    } else if (const auto* number = std::get_if<double>(&argument)) {
        lo_message_add_double(message, *number);
    } else {
        lo_message_add_string(message, std::get<std::string>(argument).c_str());
    }
}

}  // namespace

void require_osc() {}

OscPacket parse_osc_packet(std::string_view bytes) {
    if (bytes.size() % 4 != 0) throw refused_message("its length is not a multiple of four");
    OscPacket packet;
    parse_element(bytes, 0, packet);
    if (size_of(packet) > kMaxOscMessages) throw refused_message("it has too many messages");
    return packet;
}

std::string osc_packet(const OscMessage& message) {
    const Message built(lo_message_new());
    for (const OscArgument& argument : message.arguments) add(built.get(), argument);
    const char* address = message.address.c_str();
    std::string bytes(lo_message_length(built.get(), address), '\0');
    lo_message_serialise(built.get(), address, bytes.data(), nullptr);
    return bytes;
}

std::vector<std::string> osc_bundles(std::span<const OscMessage> messages) {
    std::vector<std::string> bundles;
    for (const OscMessage& message : messages) {
        const std::string bytes = osc_packet(message);
        if (bundles.empty() || bundles.back().size() + 4 + bytes.size() > kMaxBundleBytes) {
            bundles.emplace_back(kBundleTag) += kImmediately;
        }
        bundles.back() += size_bytes(bytes.size()) + bytes;
    }
    return bundles;
}

#else

void require_osc() {
    throw Error(ErrorKind::unsupported, "this build is without liblo, which OSC needs");
}

OscPacket parse_osc_packet(std::string_view) {
    require_osc();
    return {};
}

std::string osc_packet(const OscMessage&) {
    require_osc();
    return {};
}

std::vector<std::string> osc_bundles(std::span<const OscMessage>) {
    require_osc();
    return {};
}

#endif

}  // namespace ocean::bridge
