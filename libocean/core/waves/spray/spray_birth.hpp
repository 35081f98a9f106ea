// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The births of one tick: where the whitecap has crossed upwards since the previous tick.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "ocean/surface.hpp"
#include "waves/spray/spray_flight.hpp"

namespace ocean {

/// A cell with W above this is white; the share of white cells is then about the mean of W.
inline constexpr float kWhite = 0.5f;

/// Returns SplitMix64's finaliser [Steele 2014]: every bit of the result depends on every bit, and
/// no two numbers have the same result.
std::uint64_t scramble(std::uint64_t value);
/// Returns the id of particle `number` of an event. All ids of one seed and tick differ.
std::uint64_t spray_id(std::uint32_t seed, std::int64_t tick, std::uint32_t cell,
                       std::uint32_t number);

/// The input of the births of one tick.
struct SprayTick {
    std::uint32_t seed;
    std::int64_t number;  // in a loop, counted within it
    double step;          // time until the next tick [s]
    double lifetime;      // s
    double density;       // particles per m^2
    double most;          // max particles of one tick
    SprayAir air;
};

/// Returns one value for each cell: 1 where it is white.
std::vector<std::uint8_t> white_cells(const Surface& map);
/// Returns the births of a tick in the order of the cells. `map`: kSprayChannels on spray_domain at
/// the tick; `white_before`: white_cells of the previous tick. Drops that do not rise are left out.
std::vector<SprayBirth> births_of(const SprayTick& tick, const Surface& map,
                                  std::span<const std::uint8_t> white_before);

}  // namespace ocean
