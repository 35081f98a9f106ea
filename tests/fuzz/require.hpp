// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// What a fuzz target asks of the code it runs: a false condition is a finding.
#pragma once

#include <cstdlib>
#include <string_view>

namespace ocean::fuzz {

inline void require(bool condition) {
    if (!condition) std::abort();
}

/// Requires a message that is safe to print: short, and without control characters.
inline void check_message(std::string_view message) {
    require(!message.empty() && message.size() < 4096);
    for (const char c : message) require(static_cast<unsigned char>(c) >= 0x20);
}

}  // namespace ocean::fuzz
