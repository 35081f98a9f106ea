// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The drainage tree: each cell has one receiver, and the outlets are its roots. It takes two bytes
// a cell: the direction of the receiver, and a bit for each neighbour that is a donor.
//
// Walks go from the outlets up, so that each receiver comes before its donors. The stems, cells
// with large catchments, are walked by one thread; the branches that join them are independent and
// are shared out.
#pragma once

#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "land/streams/stream_flood.hpp"
#include "land/streams/stream_grid.hpp"
#include "land/streams/stream_work.hpp"

namespace ocean {

inline constexpr double kReceiverWork = 25.0;  // [ns] a cell
inline constexpr double kCountWork = 15.0;
inline constexpr double kWalkWork = 20.0;

/// Points each cell that is neither an outlet nor kFlooded to its steepest lower neighbour; a cell
/// without a lower neighbour keeps its direction. A hash of the place weights the slopes by up to
/// 15 % to each side, because valleys would otherwise keep to the eight directions of the grid: a
/// random choice between neighbours, as in [Fairfield and Leymarie 1991].
void choose_receivers(const StreamGrid& grid, std::uint32_t seed, std::span<const float> heights,
                      std::span<std::uint8_t> directions, StreamWork& work);

/// Writes bit q for each cell whose neighbour in direction q drains into it. Clears kFlooded.
void find_donors(const StreamGrid& grid, std::span<std::uint8_t> directions,
                 std::span<std::uint8_t> donors, StreamWork& work);

/// Writes the number of cells that drain through each cell, itself included. Overwrites `pending`.
void count_cells(const StreamGrid& grid, std::span<const std::uint8_t> directions,
                 std::span<const std::uint8_t> donors, std::span<std::uint8_t> pending,
                 std::span<std::uint32_t> counts, StreamWork& work);

class StreamWalk {
  public:
    /// Finds the stems. The spans must outlive the walk, except for the counts.
    StreamWalk(const StreamGrid& grid, std::span<const std::uint8_t> directions,
               std::span<const std::uint8_t> donors, std::span<const std::uint32_t> counts,
               StreamWork& work);

    /// Calls visit(cell, receiver, direction) for every cell but the outlets, each receiver before
    /// its donors, on all threads. visit may read the receiver and write the cell.
    template <typename Visit>
    void up(StreamWork& work, const Visit& visit) const {
        for (std::size_t k = 0; k < stems_.size(); ++k) {
            const CellIndex p = stems_[k];
            if (directions_[p] != kOutlet) visit(p, receiver_of(p), directions_[p]);
            if (k % kStemsBetweenReports == 0) work.add(0.0);
        }
        each_group(work, [&](std::size_t first, std::size_t last) {
            std::vector<CellIndex> open;
            for (std::size_t k = first; k < last; ++k) {
                open_branches(stems_[k], open);
                while (!open.empty()) {
                    const CellIndex p = open.back();
                    open.pop_back();
                    visit(p, receiver_of(p), directions_[p]);
                    open_donors(p, open);
                }
            }
        });
    }

    /// Calls visit(path) for every cell but the outlets, on all threads. `path` has the cells from
    /// the outlet to the cell. visit may read and write the cell alone.
    template <typename Visit>
    void up_with_paths(StreamWork& work, const Visit& visit) const {
        each_group(work, [&](std::size_t first, std::size_t last) {
            std::vector<CellIndex> path = path_to(stems_[first]);
            std::vector<CellIndex> open;
            path.pop_back();
            for (std::size_t k = first; k < last; ++k) {
                step(path, stems_[k], visit);
                open_branches(stems_[k], open);
                while (!open.empty()) {
                    const CellIndex p = open.back();
                    open.pop_back();
                    step(path, p, visit);
                    open_donors(p, open);
                }
            }
        });
    }

  private:
    static constexpr std::size_t kStemsBetweenReports = 1 << 14;

    CellIndex receiver_of(CellIndex p) const { return neighbours_.towards(p, directions_[p]); }
    bool is_stem(CellIndex p) const { return ((stem_bits_[p >> 6] >> (p & 63)) & 1) != 0; }
    std::vector<CellIndex> path_to(CellIndex p) const;

    template <typename Visit>
    void step(std::vector<CellIndex>& path, CellIndex p, const Visit& visit) const {
        if (directions_[p] == kOutlet) {
            path.assign(1, p);
            return;
        }
        while (path.back() != receiver_of(p)) path.pop_back();
        path.push_back(p);
        visit(std::span<const CellIndex>(path));
    }
    void open_donors(CellIndex p, std::vector<CellIndex>& open) const {
        for (unsigned bits = donors_[p]; bits != 0; bits &= bits - 1) {
            open.push_back(neighbours_.towards(p, std::countr_zero(bits)));
        }
    }
    /// Opens the donors of a stem that are not stems themselves.
    void open_branches(CellIndex stem, std::vector<CellIndex>& open) const;
    void each_group(StreamWork& work,
                    const std::function<void(std::size_t first, std::size_t last)>& body) const;

    Neighbours neighbours_;
    std::span<const std::uint8_t> directions_;
    std::span<const std::uint8_t> donors_;
    std::vector<CellIndex> stems_;  // outlets with donors included; receivers first
    std::vector<std::uint64_t> stem_bits_;
    std::vector<std::size_t> groups_;  // the first stem of each group, and the end
};

}  // namespace ocean
