// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Heights along a drainage tree, from the outlets up: the steady state, and the land at an age.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "land/streams/stream_grid.hpp"
#include "land/streams/stream_tree.hpp"

namespace ocean {

/// The steady slope where uplift is 1, as a function of the cells that drain: slope (max(count
/// cell^2, A_h) / A_h)^-m. Straight lines between 256 nodes an octave: within 2e-6 of the law. It
/// uses + - * / and roots alone, so that all machines get the same bits.
class SteadySlope {
  public:
    SteadySlope(const StreamSettings& settings, double cell);

    float operator()(std::uint32_t count) const;
    float max() const { return max_; }  // settings.max_slope

  private:
    float max_;
    std::vector<float> nodes_;
};

/// The least uplift that this arithmetic resolves.
inline constexpr float kMinUplift = 1e-3f;

/// Writes the steady heights Z of all cells but the outlets, which keep their heights: the slope is
/// U times the steady slope, at most max_slope, and heights rise strictly upstream. Unless
/// `response` is empty, writes to it the time that a slope takes from the outlet, dtau = dZ / U [m
/// per unit of uplift].
void set_steady(const StreamGrid& grid, const SteadySlope& slope, const StreamWalk& walk,
                std::span<const std::uint32_t> counts, std::span<const float> uplift,
                std::span<float> heights, std::span<float> response, StreamWork& work);

/// Writes the heights of an age from steady heights and response times: see set_age.
void set_aged(const StreamWalk& walk, double time, std::span<const float> steady,
              std::span<const float> response, std::span<float> heights, StreamWork& work);

}  // namespace ocean
