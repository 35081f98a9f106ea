// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The identity of a grid of heights: see height_hash in elevation.hpp.
#include <algorithm>
#include <bit>
#include <cstdint>

#include "ocean/internal/elevation.hpp"
#include "ocean/internal/sha256.hpp"
#include "ocean/internal/text.hpp"

namespace ocean {

std::vector<std::byte> bytes_of_heights(std::span<const float> heights) {
    std::vector<std::byte> bytes;
    bytes.reserve(4 * heights.size());
    for (const float height : heights) {
        const auto bits = std::bit_cast<std::uint32_t>(height);
        for (int shift = 0; shift < 32; shift += 8) {
            bytes.push_back(static_cast<std::byte>(bits >> shift));
        }
    }
    return bytes;
}

namespace {

std::string head_of(const Domain& grid) {
    std::string head;
    for (std::size_t axis = 0; axis < 2; ++axis) {
        // Nine digits, because a cell read back from text may differ in its last bits.
        head += format_text("%d %.9g\n", grid.samples[axis], grid.step(axis));
    }
    return head;
}

std::string hash_of(const std::string& head, std::span<const float> heights) {
    std::vector<std::byte> bytes;
    for (const char c : head) bytes.push_back(static_cast<std::byte>(c));
    const std::vector<std::byte> all = bytes_of_heights(heights);
    bytes.insert(bytes.end(), all.begin(), all.end());
    return sha256_hex(bytes);
}

}  // namespace

std::string height_hash(const Domain& grid, std::span<const float> heights) {
    return hash_of(head_of(grid), heights);
}

bool is_comma_hash(const std::string& stated, const Domain& grid, std::span<const float> heights) {
    std::string head = head_of(grid);
    std::ranges::replace(head, '.', ',');
    return stated == hash_of(head, heights);
}

}  // namespace ocean
