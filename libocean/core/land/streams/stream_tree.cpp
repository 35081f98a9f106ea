// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Receivers, donors, areas and stems: see stream_tree.hpp.
#include "land/streams/stream_tree.hpp"

#include <algorithm>
#include <array>

namespace ocean {
namespace {

constexpr float kTurn = 0.3f;  // range of the weights

/// Returns the direction of the steepest weighted slope among the neighbours of a mask, or
/// `otherwise` if no neighbour is lower.
template <bool kInside>
std::uint8_t steepest(const float* at, const std::array<std::int64_t, 8>& offsets,
                      std::uint64_t hash, unsigned mask, std::uint8_t otherwise) {
    constexpr float kDiagonal = 0.70710678f;
    const float height = *at;
    float best = 0.0f;
    std::uint8_t direction = otherwise;
    for (int q = 0; q < kDirections; ++q) {
        if constexpr (!kInside) {
            if (((mask >> q) & 1) == 0) continue;
        }
        const float turn =
            1.0f - 0.5f * kTurn + kTurn / 255.0f * static_cast<float>((hash >> (8 * q)) & 0xFF);
        const float drop = height - at[offsets[static_cast<std::size_t>(q)]];
        const float slope = drop * turn * ((q & 1) != 0 ? kDiagonal : 1.0f);
        if (slope > best) {
            best = slope;
            direction = static_cast<std::uint8_t>(q);
        }
    }
    return direction;
}

/// Returns a bit for each neighbour of a cell in the grid.
unsigned neighbours_inside(const StreamGrid& grid, int i, int j) {
    unsigned mask = 0;
    for (int q = 0; q < kDirections; ++q) {
        const auto at = static_cast<std::size_t>(q);
        if (grid.contains(i + kStepX[at], j + kStepY[at])) mask |= 1u << q;
    }
    return mask;
}

/// Writes the donors of a row between the borders, many cells at once.
void donors_of_row(const StreamGrid& grid, int j, const std::uint8_t* directions,
                   std::uint8_t* donors) {
    const std::uint8_t* const south = directions + grid.index(0, j - 1);
    const std::uint8_t* const here = directions + grid.index(0, j);
    const std::uint8_t* const north = directions + grid.index(0, j + 1);
    std::uint8_t* const to = donors + grid.index(0, j);
    for (int i = 1; i < grid.columns - 1; ++i) {
        const auto bit = [](std::uint8_t there, int q) {
            return static_cast<std::uint8_t>(there == opposite(q) ? 1u << q : 0u);
        };
        to[i] = static_cast<std::uint8_t>(
            bit(here[i + 1], 0) | bit(north[i + 1], 1) | bit(north[i], 2) | bit(north[i - 1], 3) |
            bit(here[i - 1], 4) | bit(south[i - 1], 5) | bit(south[i], 6) | bit(south[i + 1], 7));
    }
}

}  // namespace

void choose_receivers(const StreamGrid& grid, std::uint32_t seed, std::span<const float> heights,
                      std::span<std::uint8_t> directions, StreamWork& work) {
    const std::array<std::int64_t, 8> offsets = grid.offsets();
    work.rows(grid, kReceiverWork, [&](int first, int last) {
        for (int j = first; j < last; ++j) {
            for (int i = 0; i < grid.columns; ++i) {
                const CellIndex p = grid.index(i, j);
                std::uint8_t& direction = directions[p];
                if ((direction & ~kDirectionBits) != 0) continue;
                const std::uint64_t hash = hash_of(seed, i, j);
                const float* const at = heights.data() + p;
                if (i > 0 && j > 0 && i < grid.columns - 1 && j < grid.rows - 1) {
                    direction = steepest<true>(at, offsets, hash, 0xFF, direction);
                } else {
                    const unsigned mask = neighbours_inside(grid, i, j);
                    direction = steepest<false>(at, offsets, hash, mask, direction);
                }
            }
        }
    });
}

void find_donors(const StreamGrid& grid, std::span<std::uint8_t> directions,
                 std::span<std::uint8_t> donors, StreamWork& work) {
    const Neighbours neighbours(grid);
    work.rows(grid, 1.0, [&](int first, int last) {
        for (CellIndex p = grid.index(0, first); p < grid.index(0, last); ++p) {
            directions[p] &= static_cast<std::uint8_t>(~kFlooded);
        }
    });
    work.rows(grid, 3.0, [&](int first, int last) {
        for (int j = first; j < last; ++j) {
            const bool is_edge = j == 0 || j == grid.rows - 1;
            if (!is_edge) donors_of_row(grid, j, directions.data(), donors.data());
            for (int i = 0; i < grid.columns; i += is_edge ? 1 : grid.columns - 1) {
                const CellIndex p = grid.index(i, j);
                const unsigned inside = neighbours_inside(grid, i, j);
                unsigned bits = 0;
                for (int q = 0; q < kDirections; ++q) {
                    if (((inside >> q) & 1) == 0) continue;
                    const bool is_donor = directions[neighbours.towards(p, q)] == opposite(q);
                    bits |= static_cast<unsigned>(is_donor) << q;
                }
                donors[p] = static_cast<std::uint8_t>(bits);
            }
        }
    });
}

void count_cells(const StreamGrid& grid, std::span<const std::uint8_t> directions,
                 std::span<const std::uint8_t> donors, std::span<std::uint8_t> pending,
                 std::span<std::uint32_t> counts, StreamWork& work) {
    const Neighbours neighbours(grid);
    work.rows(grid, 1.0, [&](int first, int last) {
        for (CellIndex p = grid.index(0, first); p < grid.index(0, last); ++p) {
            pending[p] = donors[p];
            counts[p] = 1;
        }
    });
    const auto follow = [&](CellIndex p) {
        // A cell passes its water on when the last of its donors has come.
        while (directions[p] != kOutlet) {
            const int q = directions[p];
            const CellIndex receiver = neighbours.towards(p, q);
            counts[receiver] += counts[p];
            pending[receiver] &= static_cast<std::uint8_t>(~(1u << opposite(q)));
            if (pending[receiver] != 0) return;
            p = receiver;
        }
    };
    constexpr CellIndex kReport = CellIndex{1} << 18;
    const auto size = static_cast<CellIndex>(grid.size());
    for (CellIndex first = 0; first < size;) {
        const CellIndex last = first + std::min(kReport, size - first);
        for (CellIndex p = first; p < last; ++p) {
            if (donors[p] == 0) follow(p);
        }
        work.add(kCountWork * (last - first));
        first = last;
    }
}

StreamWalk::StreamWalk(const StreamGrid& grid, std::span<const std::uint8_t> directions,
                       std::span<const std::uint8_t> donors, std::span<const std::uint32_t> counts,
                       StreamWork& work)
    : neighbours_(grid),
      directions_(directions),
      donors_(donors),
      stem_bits_(grid.size() / 64 + 1) {
    constexpr std::uint32_t kMaxBranch = 1 << 12;  // cells
    constexpr std::uint64_t kGroup = 1 << 16;
    std::uint64_t cells = kGroup;
    std::vector<CellIndex> open;
    const auto size = static_cast<CellIndex>(grid.size());
    for (CellIndex p = 0; p < size; ++p) {
        if (p % (1 << 18) == 0) work.add(0.0);
        if (directions[p] != kOutlet || donors[p] == 0) continue;
        open.push_back(p);
        while (!open.empty()) {
            const CellIndex stem = open.back();
            open.pop_back();
            if (cells >= kGroup) {
                groups_.push_back(stems_.size());
                cells = 0;
            }
            stems_.push_back(stem);
            stem_bits_[stem >> 6] |= std::uint64_t{1} << (stem & 63);
            ++cells;
            for (unsigned bits = donors[stem]; bits != 0; bits &= bits - 1) {
                const CellIndex donor = neighbours_.towards(stem, std::countr_zero(bits));
                if (counts[donor] > kMaxBranch) {
                    open.push_back(donor);
                } else {
                    cells += counts[donor];
                }
            }
        }
    }
    groups_.push_back(stems_.size());
}

std::vector<CellIndex> StreamWalk::path_to(CellIndex p) const {
    std::vector<CellIndex> path = {p};
    while (directions_[p] != kOutlet) {
        p = receiver_of(p);
        path.push_back(p);
    }
    std::ranges::reverse(path);
    return path;
}

void StreamWalk::open_branches(CellIndex stem, std::vector<CellIndex>& open) const {
    for (unsigned bits = donors_[stem]; bits != 0; bits &= bits - 1) {
        const CellIndex donor = neighbours_.towards(stem, std::countr_zero(bits));
        if (!is_stem(donor)) open.push_back(donor);
    }
}

void StreamWalk::each_group(
    StreamWork& work, const std::function<void(std::size_t first, std::size_t last)>& body) const {
    const int count = static_cast<int>(groups_.size()) - 1;
    constexpr double kCells = 1 << 16;
    work.each(count, kWalkWork * kCells, [&](int group) {
        body(groups_[static_cast<std::size_t>(group)],
             groups_[static_cast<std::size_t>(group) + 1]);
    });
}

}  // namespace ocean
