// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Addresses that a bridge listens at, this machine's interfaces, the token that clients need, and
// the number of connections that the system allows.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace ocean::bridge {

/// A port of a host: an IPv4 or IPv6 address, or a name that the system looks up.
struct Endpoint {
    std::string host = "127.0.0.1";
    unsigned short port = 4747;

    /// Returns "127.0.0.1:4747", or "[::1]:4747" for IPv6.
    std::string text() const;
    /// Returns true for 127.x.x.x, ::1 and localhost.
    bool is_loopback() const;
    bool operator==(const Endpoint&) const = default;
};

/// Parses "HOST:PORT", "[::1]:4747", or HOST alone, which gets `default_port`. Messages begin with
/// `what`, such as the name of an option. Throws Error invalid_value.
Endpoint parse_endpoint(std::string_view text, const std::string& what,
                        unsigned short default_port = Endpoint().port);

/// Returns the interfaces that are up, with their addresses: "lo 127.0.0.1", "eth0 192.168.1.7".
std::vector<std::string> network_interfaces();

/// Returns the token in a file: one line of 16 .. 256 printable ASCII characters without blanks.
/// Throws Error bad_file for another content, and for a file that other users may read.
std::string read_token(const std::string& path);
/// Compares in a time that depends on the length of `guess` alone. Returns false for an empty
/// token.
bool same_token(std::string_view guess, std::string_view token);

/// Raises this process's limit of open descriptors so that `count` more can be opened. Throws Error
/// unsupported, with the number that is allowed, if the system refuses.
void require_descriptors(std::size_t count);

}  // namespace ocean::bridge
