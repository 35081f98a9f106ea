// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// What water.vert, water.frag, seed.vert and seed.frag of shaders/preview are compiled with.
#pragma once

#include <compare>
#include <cstddef>
#include <string>

#include "view_table.hpp"

namespace ocean::preview {

/// Of the look `seed`, along each side, around the origin of the world.
inline constexpr int kSeedTiles = 10;

inline std::string define(const std::string& name, int value) {
    return "#define " + name + " " + std::to_string(value) + "\n";
}

/// What a program of the water is for.
struct WaterParts {
    std::size_t cascades = 0;
    std::size_t covers = 0;
    bool lace = false;      // the foam has its pattern
    std::size_t tiles = 0;  // of slopes
    bool below = false;     // the eye may be under water

    auto operator<=>(const WaterParts&) const = default;
};

/// taps: of a footprint; 0: the driver's filter.
inline std::string water_defines(const WaterParts& parts, int taps) {
    return define("CASCADES", static_cast<int>(parts.cascades)) +
           define("COVERS", static_cast<int>(parts.covers)) + define("LACE", parts.lace ? 1 : 0) +
           define("DETAIL", static_cast<int>(parts.tiles)) + define("BELOW", parts.below ? 1 : 0) +
           define("TAPS", taps) + define("TILES", kSeedTiles) + view_defines();
}

}  // namespace ocean::preview
