// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The births of one tick: where the whitecap has crossed upwards since the tick before.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "ocean/surface.hpp"
#include "waves/spray/spray_flight.hpp"

namespace ocean {

/// Above it a cell is white: the share of the sea that is, is then about the mean of W.
inline constexpr float kWhite = 0.5f;

/// Returns SplitMix64's finaliser [Steele 2014]: every bit of the result depends on every bit, and
/// no two numbers have the same result.
std::uint64_t scramble(std::uint64_t value);
/// Returns the id of particle `number` of an event. For one seed and tick no two are equal.
std::uint64_t spray_id(std::uint32_t seed, std::int64_t tick, std::uint32_t cell,
                       std::uint32_t number);

/// The input of the births of one tick.
struct SprayTick {
    std::uint32_t seed;
    std::int64_t number;  // in a loop that within it
    double step;          // s, until the next
    double lifetime;      // s
    double density;       // particles per m^2
    double most;          // particles of one tick
    SprayAir air;
};

/// Returns one value for each cell: 1 where it is white.
std::vector<std::uint8_t> white_cells(const Surface& map);
/// Returns the births of a tick in the order of the cells. `map`: kSprayChannels on
/// spray_domain at the tick; `white_before`: white_cells of the tick before. Drops that do not rise
/// are left out.
std::vector<SprayBirth> births_of(const SprayTick& tick, const Surface& map,
                                  std::span<const std::uint8_t> white_before);

}  // namespace ocean
