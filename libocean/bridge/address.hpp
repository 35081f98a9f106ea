// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// What a command line says of an address, as asio has it.
#pragma once

#include <asio.hpp>
#include <string>

#include "ocean/error.hpp"
#include "ocean/internal/checked_text.hpp"

namespace ocean::bridge {

/// Throws Error invalid_value for names but localhost: of them others decide.
inline asio::ip::address parse_address(const std::string& host, const std::string& what) {
    asio::error_code wrong;
    const auto address = asio::ip::make_address(host == "localhost" ? "127.0.0.1" : host, wrong);
    if (!wrong) return address;
    const std::string given = text::printable(host);
    const std::string allowed = "one in numbers, or localhost";
    throw Error(ErrorKind::invalid_value,
                what + " " + given + ": is no address; allowed: " + allowed,
                {.what = "is no address", .parameter = what, .value = given, .allowed = allowed});
}

}  // namespace ocean::bridge
