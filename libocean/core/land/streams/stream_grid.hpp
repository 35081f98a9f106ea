// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The grid that water runs on: cells, their eight neighbours, and the direction of a neighbour as a
// byte.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace ocean {

/// The direction q points to (kStepX[q], kStepY[q]), counter-clockwise from east; q + 4 is the
/// opposite one.
using Direction = std::uint8_t;
inline constexpr int kDirections = 8;
inline constexpr std::array<int, 8> kStepX = {1, 1, 0, -1, -1, -1, 0, 1};
inline constexpr std::array<int, 8> kStepY = {0, 1, 1, 1, 0, -1, -1, -1};

constexpr Direction opposite(int direction) {
    return static_cast<Direction>((direction + 4) & 7);
}

/// An index of a cell, row-major from the south-west.
using CellIndex = std::uint32_t;

struct StreamGrid {
    int columns;
    int rows;
    double cell;  // [m]

    std::size_t size() const {
        return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
    }
    CellIndex index(int i, int j) const {
        return static_cast<CellIndex>(j) * static_cast<CellIndex>(columns) +
               static_cast<CellIndex>(i);
    }
    bool contains(int i, int j) const { return i >= 0 && j >= 0 && i < columns && j < rows; }
    /// Returns the difference of the indices of a neighbour and the cell.
    std::int64_t offset(int direction) const {
        const auto q = static_cast<std::size_t>(direction);
        return std::int64_t{kStepY[q]} * columns + kStepX[q];
    }
    std::array<std::int64_t, 8> offsets() const {
        std::array<std::int64_t, 8> all{};
        for (int q = 0; q < kDirections; ++q) all[static_cast<std::size_t>(q)] = offset(q);
        return all;
    }
    /// Returns the distance of a neighbour [m].
    double distance(int direction) const {
        constexpr double kRootTwo = 1.4142135623730951;
        return (direction & 1) != 0 ? cell * kRootTwo : cell;
    }
};

/// The neighbours of cells. Walks in arbitrary order need the column of a cell to know whether it
/// is at the border.
class Neighbours {
  public:
    explicit Neighbours(const StreamGrid& grid) : grid_(grid), offsets_(grid.offsets()) {}

    CellIndex towards(CellIndex p, int direction) const {
        return static_cast<CellIndex>(p + offsets_[static_cast<std::size_t>(direction)]);
    }
    /// Calls visit(direction, neighbour) for each neighbour in the grid.
    template <typename Visit>
    void each(CellIndex p, const Visit& visit) const {
        const auto columns = static_cast<CellIndex>(grid_.columns);
        const auto j = static_cast<int>(p / columns);
        const auto i = static_cast<int>(p % columns);
        if (i > 0 && j > 0 && i < grid_.columns - 1 && j < grid_.rows - 1) {
            for (int q = 0; q < kDirections; ++q) visit(q, towards(p, q));
            return;
        }
        for (int q = 0; q < kDirections; ++q) {
            const auto at = static_cast<std::size_t>(q);
            if (grid_.contains(i + kStepX[at], j + kStepY[at])) visit(q, towards(p, q));
        }
    }

  private:
    StreamGrid grid_;
    std::array<std::int64_t, 8> offsets_;
};

/// Returns h + rise, or the next float above h if that is higher, so that water falls to h.
inline float risen(float h, float rise) {
    const auto bits = std::bit_cast<std::uint32_t>(h + 0.0f);  // -0 becomes 0
    const std::uint32_t next = (bits & 0x80000000u) != 0 ? bits - 1 : bits + 1;
    return std::max(h + rise, std::bit_cast<float>(next));
}

/// Returns 64 random bits of a place on a grid: the finaliser of SplitMix64 [Steele 2014].
inline std::uint64_t hash_of(std::uint32_t seed, int i, int j) {
    std::uint64_t h =
        (std::uint64_t{static_cast<std::uint32_t>(j)} << 32 | static_cast<std::uint32_t>(i)) +
        (std::uint64_t{seed} + 1) * 0x9E3779B97F4A7C15u;
    h = (h ^ (h >> 30)) * 0xBF58476D1CE4E5B9u;
    h = (h ^ (h >> 27)) * 0x94D049BB133111EBu;
    return h ^ (h >> 31);
}

}  // namespace ocean
