// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// SHA-256 of bytes that arrive in pieces, by a library of the system: sha256_openssl.cpp,
// sha256_windows.cpp.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

namespace ocean {

class Sha256 {
  public:
    Sha256();
    ~Sha256();
    Sha256(const Sha256&) = delete;
    Sha256& operator=(const Sha256&) = delete;

    void add(std::string_view bytes);
    /// Returns 64 hexadecimal digits in lower case. Call it once, after the last add().
    std::string hex();

  private:
    std::array<unsigned char, 32> digest();

    struct Impl;
    std::unique_ptr<Impl> impl_;
};

std::string sha256_hex(std::string_view bytes);

/// The digits of the hashes by which headers and manifests tell one thing from another.
inline constexpr std::size_t kShortHashDigits = 16;
/// Returns the first digits of the SHA-256.
std::string short_hash(std::string_view bytes);

}  // namespace ocean
