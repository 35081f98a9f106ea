// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The priority flood. Only cells with a lower neighbour that water has not reached enter a heap:
// everything that rises from a drained cell drains already, and is walked by a stack [Wei 2018].
#include "terrain/stream_flood.hpp"

#include <bit>
#include <functional>
#include <queue>
#include <vector>

namespace ocean {
namespace {

constexpr float kDrop = 1e-4f;  // of a drained hollow from cell to cell [m]

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
        : neighbours_(grid), to_(to), heights_(heights), directions_(directions), work_(work) {}

    void run() {
        const auto size = static_cast<CellIndex>(heights_.size());
        for (CellIndex p = 0; p < size; ++p) {
            if (directions_[p] == kOutlet) climb(p);
        }
        while (!rims_.empty()) {
            const auto p = static_cast<CellIndex>(rims_.top());
            rims_.pop();
            pour_from(p);
        }
        work_.add(kFloodWork * (static_cast<double>(size) - static_cast<double>(reported_)));
    }

  private:
    using Heap =
        std::priority_queue<std::uint64_t, std::vector<std::uint64_t>, std::greater<>>;

    /// Reaches all cells that rise from a drained one. Those from which water could fall into cells
    /// that it has not reached become rims.
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
            if (is_rim) rims_.push(key_of(height, p));
        }
    }

    /// Fills the hollows beyond a rim.
    void pour_from(CellIndex rim) {
        reach_from(rim);
        while (!hollow_.empty()) {
            const auto p = static_cast<CellIndex>(hollow_.top());
            hollow_.pop();
            count();
            reach_from(p);
        }
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
            const float ground = heights_[r];
            heights_[r] = to_ == FloodTo::carve ? level : risen(level, kDrop);
            hollow_.push(key_of(to_ == FloodTo::carve ? ground : heights_[r], r));
        });
    }

    void count() {
        constexpr std::uint64_t kReport = std::uint64_t{1} << 18;
        if (++counted_ % kReport != 0) return;
        work_.add(kFloodWork * static_cast<double>(kReport));
        reported_ = counted_;
    }

    Neighbours neighbours_;
    FloodTo to_;
    std::span<float> heights_;
    std::span<std::uint8_t> directions_;
    StreamWork& work_;
    std::vector<CellIndex> above_;
    Heap rims_;
    Heap hollow_;
    std::uint64_t counted_ = 0;
    std::uint64_t reported_ = 0;
};

}  // namespace

void flood(const StreamGrid& grid, FloodTo to, std::span<float> heights,
           std::span<std::uint8_t> directions, StreamWork& work) {
    Flood(grid, to, heights, directions, work).run();
}

}  // namespace ocean
