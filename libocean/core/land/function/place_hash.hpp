// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A hash of places on a lattice, in 32-bit arithmetic, which shaders have too.
#pragma once

#include <cstdint>

namespace ocean {

/// Returns 32 well mixed bits of the vertex (i, j): a weighted sum, finished by the mixer of
/// [Wellons 2018].
constexpr std::uint32_t place_hash(std::uint32_t i, std::uint32_t j, std::uint32_t seed) {
    std::uint32_t h = (i * 0x8DA6B343u) ^ (j * 0xD8163841u) ^ (seed * 0xCB1AB31Fu);
    h ^= h >> 16;
    h *= 0x7FEB352Du;
    h ^= h >> 15;
    h *= 0x846CA68Bu;
    h ^= h >> 16;
    return h;
}

}  // namespace ocean
