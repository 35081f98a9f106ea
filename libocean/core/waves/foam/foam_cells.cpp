// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The nearest two of random points, one in each cell of a lattice. The search examines the nine
// cells around a place, then the cells of the next ring that may hold a nearer point.
#include "waves/foam/foam_cells.hpp"

#include <algorithm>
#include <cmath>

#include "wave/wave.hpp"

namespace ocean {
namespace {

/// Cells of the neighbouring periods that are kept: the reach of places, and two rings.
constexpr int kMargin = static_cast<int>(FoamCells::kReach) + 3;

}  // namespace

FoamCells::FoamCells(std::uint32_t seed, std::uint32_t field, int count, float spread)
    : count_(count), width_(count + 2 * kMargin), spread_(spread) {
    points_.reserve(static_cast<std::size_t>(width_) * static_cast<std::size_t>(width_));
    for (int j = 0; j < width_; ++j) {
        for (int i = 0; i < width_; ++i) points_.push_back(point(seed, field, i, j));
    }
}

FoamCells::Point FoamCells::point(std::uint32_t seed, std::uint32_t field, int i, int j) const {
    const auto own = [this](int cell) {
        return static_cast<std::uint32_t>((cell - kMargin + count_) % count_);
    };
    // The counter's last word is 1 here and 0 for Gaussian noise, so that the numbers of both
    // differ.
    const auto bits =
        wave::single_precision::philox_4x32(own(i), own(j), field, 1u, seed, 0x6F636561u);
    const auto share = [](std::uint32_t word) { return static_cast<float>(word >> 8) * 0x1p-24f; };
    const float size = share(bits.c);
    return {static_cast<float>(i) + share(bits.a), static_cast<float>(j) + share(bits.b),
            spread_ * size * size};
}

FoamCells::Distances FoamCells::at(float x, float y) const {
    x += static_cast<float>(kMargin);
    y += static_cast<float>(kMargin);
    const int i = static_cast<int>(x), j = static_cast<int>(y);
    Distances found{9.0f, 9.0f};
    const auto look = [&](int from_x, int to_x, int from_y, int to_y) {
        for (int row = j + from_y; row <= j + to_y; ++row) {
            const Point* points = points_.data() + row * width_ + i;
            for (int column = from_x; column <= to_x; ++column) {
                const Point& p = points[column];
                const float dx = p.x - x, dy = p.y - y;
                const float d = std::sqrt(dx * dx + dy * dy) - p.weight;
                found.second = std::min(found.second, std::max(found.first, d));
                found.first = std::min(found.first, d);
            }
        }
    };
    look(-1, 1, -1, 1);
    // The min distance of a point of the second ring, minus its weight.
    const float left = x - static_cast<float>(i) + 1.0f - spread_;
    const float below = y - static_cast<float>(j) + 1.0f - spread_;
    const float right = 3.0f - 2.0f * spread_ - left, above = 3.0f - 2.0f * spread_ - below;
    if (left < found.second) look(-2, -2, -2, 2);
    if (right < found.second) look(2, 2, -2, 2);
    if (below < found.second) look(-1, 1, -2, -2);
    if (above < found.second) look(-1, 1, 2, 2);
    return found;
}

}  // namespace ocean
