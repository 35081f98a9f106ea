// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Any bytes as what a child process sends.
#pragma once

#include <algorithm>
#include <cstdint>

#include "ocean/internal/child_process.hpp"

namespace ocean::fuzz {

/// Returns a source of these bytes, which must live as long; it ends with them.
inline sandbox::Source child_bytes(const std::uint8_t* data, std::size_t size) {
    return [data, size](void* to, std::size_t count) mutable {
        if (count > size) return false;
        std::copy_n(data, count, static_cast<std::uint8_t*>(to));
        data += count;
        size -= count;
        return true;
    };
}

}  // namespace ocean::fuzz
