// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "sha256.hpp"

namespace ocean {

std::string Sha256::hex() {
    std::string text;
    for (const unsigned char byte : digest()) {
        constexpr char kDigits[] = "0123456789abcdef";
        text += kDigits[byte >> 4];
        text += kDigits[byte & 15];
    }
    return text;
}

std::string sha256_hex(std::string_view bytes) {
    Sha256 hash;
    hash.add(bytes);
    return hash.hex();
}

std::string short_hash(std::string_view bytes) {
    return sha256_hex(bytes).substr(0, kShortHashDigits);
}

}  // namespace ocean
