// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The windows of time through which labels are followed: a fixed set, so that results change
// smoothly with the sea.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "ocean/thread_pool.hpp"
#include "waves/foam/foam_ages.hpp"
#include "waves/foam/gradient_process.hpp"

namespace ocean {

/// Number of windows in each draw of a process, so far apart that their whitecaps are nearly
/// independent.
inline constexpr int kWindowsOfDraw = 64;

/// Returns how many draws are followed: 256, or fewer where windows are long.
inline int window_draws(const Stretch& stretch) {
    constexpr int kDraws = 256;
    constexpr int kTicks = 1 << 23;
    return std::clamp(kTicks / (2 * stretch.reach * kWindowsOfDraw), 4, kDraws);
}

/// The middle of a window, and the position of its gradients in their distribution.
struct WindowPlace {
    std::size_t tick;
    std::size_t stretch;  // 0 or 1: index of the draw's stretch
    double of_nodes, of_depth;
};

/// Returns the place of window i of a draw.
inline WindowPlace window_place(const Stretch& stretch, int draw, int i) {
    // These are places of the two-dimensional golden ratio: as even as a lattice, for any number.
    const double number = draw * kWindowsOfDraw + i + 0.5;
    const double of_nodes = number * 0.7548776662466927;
    const double of_depth = number * 0.5698402909980532;
    return {static_cast<std::size_t>(static_cast<std::int64_t>(i) * stretch.ticks / kWindowsOfDraw),
            static_cast<std::size_t>(i % 2), of_nodes - std::floor(of_nodes),
            of_depth - std::floor(of_depth)};
}

/// Returns the sum of the contributions that follow(draw, followed) adds for each draw. `follow`
/// runs in parallel, and the sum is the same for any number of threads.
template <typename Follow>
FollowedFoam follow_draws(const Stretch& stretch, ThreadPool& pool, const Follow& follow) {
    const int draws = window_draws(stretch);
    std::vector<FollowedFoam> parts(static_cast<std::size_t>(draws));
    pool.for_each_item(draws,
                       [&](int draw, int) { follow(draw, parts[static_cast<std::size_t>(draw)]); });
    FollowedFoam all;
    for (const FollowedFoam& part : parts) all.add(part);
    return all;
}

}  // namespace ocean
