// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Where a bridge listens and who may talk to it: addresses, this machine's interfaces, the token,
// and how many connections the system allows.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace ocean::bridge {

/// An address of IPv4 or IPv6, or a name that the system looks up.
struct Endpoint {
    std::string host = "127.0.0.1";
    unsigned short port = 4747;

    /// "127.0.0.1:4747", "[::1]:4747".
    std::string text() const;
    /// 127.x.x.x, ::1 or localhost.
    bool is_loopback() const;
    bool operator==(const Endpoint&) const = default;
};

/// "HOST:PORT", "[::1]:4747", or HOST alone with the usual port. Throws Error invalid_value.
Endpoint parse_endpoint(std::string_view text, const std::string& what,
                        unsigned short usual_port = Endpoint().port);

/// "lo 127.0.0.1", "eth0 192.168.1.7": those that are up.
std::vector<std::string> network_interfaces();

/// The one line of a file that nobody but its owner may read: 16 .. 256 printable characters
/// without blanks. Throws Error bad_file.
std::string read_token(const std::string& path);
/// Takes the same time for every guess of a length.
bool same_token(std::string_view guess, std::string_view token);

/// Raises the limit of descriptors as far as needed for so many more than are open. Throws Error
/// unsupported that says what is allowed, where the system refuses.
void require_descriptors(std::size_t count);

}  // namespace ocean::bridge
