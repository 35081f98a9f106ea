// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Addresses of a command line as values of asio.
#pragma once

#include <asio.hpp>
#include <string>

#include "ocean/error.hpp"
#include "ocean/internal/checked_text.hpp"

namespace ocean::bridge {

/// Parses an address, or localhost. Throws Error invalid_value for another name, because a name
/// server would choose its address.
inline asio::ip::address parse_address(const std::string& host, const std::string& what) {
    asio::error_code wrong;
    const auto address = asio::ip::make_address(host == "localhost" ? "127.0.0.1" : host, wrong);
    if (!wrong) return address;
    const std::string given = text::printable(host);
    const std::string allowed = "a numeric address, or localhost";
    throw Error(
        ErrorKind::invalid_value, what + " " + given + ": is not an address; allowed: " + allowed,
        {.what = "is not an address", .parameter = what, .value = given, .allowed = allowed});
}

}  // namespace ocean::bridge
