// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The priority flood. Only cells with a lower neighbour that water has not reached enter a heap:
// cells that rise from a drained cell drain already, and a stack walks them [Wei 2018].
#include "land/streams/stream_flood.hpp"

#include <bit>
#include <functional>
#include <queue>
#include <vector>

namespace ocean {
namespace {

constexpr float kDrop = 1e-4f;  // rise of a drained hollow from cell to cell [m]

/// Returns a number that orders heights and then indices.
std::uint64_t key_of(float height, CellIndex p) {
    const auto bits = std::bit_cast<std::uint32_t>(height + 0.0f);  // -0 becomes 0
    const std::uint32_t ordered = (bits & 0x80000000u) != 0 ? ~bits : bits | 0x80000000u;
    return std::uint64_t{ordered} << 32 | p;
}

class Flood {
  public:
    Flood(const StreamGrid& grid, FloodTo to, std::span<float> heights,
          std::span<std::uint8_t> directions, StreamWork& work)
        : columns_(static_cast<CellIndex>(grid.columns)),
          neighbours_(grid),
          to_(to),
          heights_(heights),
          directions_(directions),
          work_(work) {}

    void run() {
        const auto size = static_cast<CellIndex>(heights_.size());
        for (CellIndex p = 0; p < size; ++p) {
            if (directions_[p] == kOutlet && !is_open_sea(p)) climb(p);
        }
        settle();
        while (!rims_.empty()) {
            const auto p = static_cast<CellIndex>(rims_.top());
            rims_.pop();
            pour_from(p);
        }
        work_.add(kFloodWork * static_cast<double>(size - reported_));
    }

  private:
    using Heap = std::priority_queue<std::uint64_t, std::vector<std::uint64_t>, std::greater<>>;

    /// Returns true for an outlet among outlets, without the column of the cell. At the border it
    /// may take cells of the other side for neighbours and return false too often.
    bool is_open_sea(CellIndex p) const {
        if (p <= columns_ || p + columns_ + 1 >= directions_.size()) return false;
        const auto three = [&](CellIndex q) {
            return directions_[q - 1] == kOutlet && directions_[q] == kOutlet &&
                   directions_[q + 1] == kOutlet;
        };
        return three(p) && three(p - columns_) && three(p + columns_);
    }

    /// Reaches all cells that rise from a drained cell. Cells from which water could fall into
    /// unreached cells become candidates for rims.
    void climb(CellIndex start) {
        above_.push_back(start);
        while (!above_.empty()) {
            const CellIndex p = above_.back();
            above_.pop_back();
            count();
            const float height = heights_[p];
            bool is_rim = false;
            neighbours_.each(p, [&](int q, CellIndex r) {
                if (directions_[r] != kUnseen) return;
                if (heights_[r] > height) {
                    directions_[r] = opposite(q);
                    above_.push_back(r);
                } else {
                    is_rim = true;
                }
            });
            if (is_rim) candidates_.push_back(p);
        }
    }

    /// Turns candidates from which water can still fall into rims.
    void settle() {
        for (const CellIndex p : candidates_) {
            bool is_rim = false;
            neighbours_.each(p, [&](int, CellIndex r) { is_rim |= directions_[r] == kUnseen; });
            if (is_rim) rims_.push(key_of(heights_[p], p));
        }
        candidates_.clear();
    }

    /// Fills the hollows beyond a rim; with FloodTo::drain, only the cells of a hollow next to it.
    void pour_from(CellIndex rim) {
        reach_from(rim);
        while (!hollow_.empty()) {
            const auto p = static_cast<CellIndex>(hollow_.top());
            hollow_.pop();
            count();
            reach_from(p);
        }
        settle();
    }

    void reach_from(CellIndex p) {
        const float level = heights_[p];
        neighbours_.each(p, [&](int q, CellIndex r) {
            if (directions_[r] != kUnseen) return;
            directions_[r] = opposite(q);
            if (heights_[r] > level) {
                climb(r);
                return;
            }
            directions_[r] |= kFlooded;
            if (to_ == FloodTo::carve) {
                // The way out runs from the deepest place up, lowest ground first.
                hollow_.push(key_of(heights_[r], r));
                heights_[r] = level;
            } else {
                // Rising water joins the water of other rims, so that level ground drains to all of
                // them.
                heights_[r] = risen(level, kDrop);
                rims_.push(key_of(heights_[r], r));
                count();
            }
        });
    }

    void count() {
        constexpr CellIndex kReport = CellIndex{1} << 18;
        if (++counted_ % kReport != 0) return;
        work_.add(kFloodWork * static_cast<double>(kReport));
        reported_ = counted_;
    }

    CellIndex columns_;
    Neighbours neighbours_;
    FloodTo to_;
    std::span<float> heights_;
    std::span<std::uint8_t> directions_;
    StreamWork& work_;
    std::vector<CellIndex> above_;
    std::vector<CellIndex> candidates_;
    Heap rims_;
    Heap hollow_;
    CellIndex counted_ = 0;   // walked cells
    CellIndex reported_ = 0;  // reported part of counted_
};

}  // namespace

void flood(const StreamGrid& grid, FloodTo to, std::span<float> heights,
           std::span<std::uint8_t> directions, StreamWork& work) {
    Flood(grid, to, heights, directions, work).run();
}

}  // namespace ocean
