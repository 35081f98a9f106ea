// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Implicit diffusion by locally one-dimensional steps: see stream_creep.hpp.
//
//   (1 + 2 k w_i) z_i - k w_i (z_(i-1) + z_(i+1)) = old z_i,   k = reach^2 / (4 steps cell^2)
//
// is solved along lines by elimination [Press 1992, 2.4], 16 lines side by side.
#include "land/streams/stream_creep.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "land/streams/stream_flood.hpp"

namespace ocean {
namespace {

constexpr int kSteps = 4;
constexpr int kLanes = 16;

/// Heights and weights of 16 lines, [place on the line][line].
struct Lines {
    explicit Lines(int length)
        : heights(static_cast<std::size_t>(length) * kLanes), weights(heights.size()) {}

    std::vector<float> heights;
    std::vector<float> weights;  // k w; then the factor between a place and the next
};

/// Solves the equations of all lines. The ends have no neighbour outside.
void solve(int length, Lines& lines) {
    float* z = lines.heights.data();
    float* w = lines.weights.data();
    for (int lane = 0; lane < kLanes; ++lane) {
        const float pivot = 1.0f / (1.0f + w[lane]);
        w[lane] *= pivot;
        z[lane] *= pivot;
    }
    for (int n = 1; n < length; ++n) {
        const bool is_end = n == length - 1;
        const float* const z_before = z;
        const float* const w_before = w;
        z += kLanes;
        w += kLanes;
        for (int lane = 0; lane < kLanes; ++lane) {
            const float links = is_end ? w[lane] : w[lane] + w[lane];
            const float pivot = 1.0f / (1.0f + links - w[lane] * w_before[lane]);
            z[lane] = (z[lane] + w[lane] * z_before[lane]) * pivot;
            w[lane] *= pivot;
        }
    }
    for (int n = length - 2; n >= 0; --n) {
        const float* const z_after = z;
        z -= kLanes;
        w -= kLanes;
        for (int lane = 0; lane < kLanes; ++lane) z[lane] += w[lane] * z_after[lane];
    }
}

class Creep {
  public:
    Creep(const StreamGrid& grid, double reach, std::span<const float> channel,
          std::span<const std::uint8_t> directions, std::span<float> heights, StreamWork& work)
        : grid_(grid),
          rate_(static_cast<float>(reach * reach / (4.0 * kSteps * grid.cell * grid.cell))),
          channel_(channel),
          directions_(directions),
          heights_(heights),
          work_(work) {}

    void run() {
        const auto columns = static_cast<std::size_t>(grid_.columns);
        for (int step = 0; step < kSteps; ++step) {
            const bool rows_first = step % 2 == 0;
            for (const bool along_rows : {rows_first, !rows_first}) {
                if (along_rows) {
                    sweep(grid_.columns, 1, grid_.rows, columns);
                } else {
                    sweep(grid_.rows, columns, grid_.columns, 1);
                }
            }
        }
    }

  private:
    /// Solves all lines of `length` cells, `along` from cell to cell and `across` from line to
    /// line.
    void sweep(int length, std::size_t along, int lines, std::size_t across) {
        constexpr double kPart = kCreepWork / (2.0 * kSteps);
        work_.each((lines + kLanes - 1) / kLanes, kPart * kLanes * length, [&](int item) {
            const int lanes = std::min(kLanes, lines - item * kLanes);
            const std::size_t first = static_cast<std::size_t>(item) * kLanes * across;
            Lines block(length);
            each_cell(length, along, lanes, across, first, [&](std::size_t at, std::size_t p) {
                block.heights[at] = heights_[p];
                block.weights[at] = directions_[p] == kOutlet ? 0.0f : rate_ * (1.0f - channel_[p]);
            });
            solve(length, block);
            each_cell(length, along, lanes, across, first, [&](std::size_t at, std::size_t p) {
                if (block.weights[at] != 0.0f) heights_[p] = block.heights[at];
            });
        });
    }

    /// Calls visit(place in Lines, cell), in the order in which the cells lie in memory.
    template <typename Visit>
    static void each_cell(int length, std::size_t along, int lanes, std::size_t across,
                          std::size_t first, const Visit& visit) {
        const auto n_count = static_cast<std::size_t>(length);
        const auto lane_count = static_cast<std::size_t>(lanes);
        if (across == 1) {
            for (std::size_t n = 0; n < n_count; ++n) {
                for (std::size_t lane = 0; lane < lane_count; ++lane) {
                    visit(n * kLanes + lane, first + n * along + lane);
                }
            }
            return;
        }
        for (std::size_t lane = 0; lane < lane_count; ++lane) {
            for (std::size_t n = 0; n < n_count; ++n) {
                visit(n * kLanes + lane, first + lane * across + n * along);
            }
        }
    }

    StreamGrid grid_;
    float rate_;
    std::span<const float> channel_;
    std::span<const std::uint8_t> directions_;
    std::span<float> heights_;
    StreamWork& work_;
};

}  // namespace

void creep(const StreamGrid& grid, double reach, std::span<const float> channel,
           std::span<const std::uint8_t> directions, std::span<float> heights, StreamWork& work) {
    if (reach <= 0.0) return;
    Creep(grid, reach, channel, directions, heights, work).run();
}

}  // namespace ocean
