// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Bilinear heights of a coarser level at shifted places: see stream_coarse.hpp.
#include "land/streams/stream_coarse.hpp"

#include <algorithm>

#include "field/bilinear.hpp"
#include "field/ease.hpp"

namespace ocean {
namespace {

/// Returns a number within -1 .. 1 from 32 random bits.
float signed_unit(std::uint64_t bits) {
    return static_cast<float>(static_cast<std::uint32_t>(bits) >> 8) * (1.0f / 8388608.0f) - 1.0f;
}

/// A position between two of `count` values in a row.
struct Between {
    Between(float place, int count)
        : low(std::min(static_cast<int>(place), count - 2)),
          part(place - static_cast<float>(low)) {}

    int low;
    float part;
};

}  // namespace

CoarseHeights::CoarseHeights(std::uint32_t seed, const StreamGrid& grid,
                             std::span<const float> start, std::span<const float> heights)
    : grid_(grid), nodes_along_(grid.columns / kSpacing + 2), change_(grid.size()) {
    for (std::size_t p = 0; p < grid.size(); ++p) change_[p] = heights[p] - start[p];
    // Nodes have other hashes than the cells of a tree.
    const std::uint32_t seed_of_nodes = seed ^ 0x73686966u;
    const int nodes_up = grid.rows / kSpacing + 2;
    shifts_.reserve(static_cast<std::size_t>(nodes_along_) * static_cast<std::size_t>(nodes_up));
    for (int j = 0; j < nodes_up; ++j) {
        for (int i = 0; i < nodes_along_; ++i) {
            const std::uint64_t hash = hash_of(seed_of_nodes, i, j);
            shifts_.push_back({kShift * signed_unit(hash), kShift * signed_unit(hash >> 32)});
        }
    }
}

CoarseHeights::Shift CoarseHeights::shift_at(int i, int j) const {
    // A node lies every 2 kSpacing fine cells.
    constexpr int kCells = 2 * kSpacing;
    const auto part = [](int cell) {
        return ease_cubic((static_cast<float>(cell % kCells) + 0.5f) * (1.0f / kCells));
    };
    const Shift* const south =
        shifts_.data() + static_cast<std::ptrdiff_t>(j / kCells) * nodes_along_ + i / kCells;
    const Shift* const north = south + nodes_along_;
    const float x = part(i), y = part(j);
    const auto mix = [&](float Shift::*axis) {
        return bilinear(south[0].*axis, south[1].*axis, north[0].*axis, north[1].*axis, x, y);
    };
    return {mix(&Shift::x), mix(&Shift::y)};
}

float CoarseHeights::change_at(int i, int j) const {
    const Shift shift = shift_at(i, j);
    // The centre of coarse cell n is the place n.
    const auto place = [](int cell, float by, int count) {
        const float centre = 0.5f * static_cast<float>(cell) - 0.25f;
        return std::clamp(centre + by, 0.0f, static_cast<float>(count - 1));
    };
    const Between x(place(i, shift.x, grid_.columns), grid_.columns);
    const Between y(place(j, shift.y, grid_.rows), grid_.rows);
    const float* const south = change_.data() + grid_.index(x.low, y.low);
    const float* const north = south + grid_.columns;
    return bilinear(south[0], south[1], north[0], north[1], x.part, y.part);
}

}  // namespace ocean
