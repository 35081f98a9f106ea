// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// SHA-256 without a library, because libocean.so depends on the C library alone. Bakes hash
// gigabytes and use OpenSSL's.
#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace ocean {

/// Returns the SHA-256 of the bytes [FIPS 180-4] as 64 hexadecimal digits in lower case.
std::string sha256_hex(std::span<const std::byte> bytes);

}  // namespace ocean
