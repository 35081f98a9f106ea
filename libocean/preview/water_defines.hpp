// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// What water.vert, water.frag, seed.vert and seed.frag of shaders/preview are compiled with.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "ocean/enum_words.hpp"
#include "ocean/preview/picture.hpp"

namespace ocean::preview {

/// Of the look `seed`, along each side, around the origin of the world.
inline constexpr int kSeedTiles = 10;

inline std::string define(const std::string& name, int value) {
    return "#define " + name + " " + std::to_string(value) + "\n";
}

/// Views by their words: VIEW_shaded. taps: of a footprint; 0: the driver's filter.
inline std::string water_defines(std::size_t cascades, std::size_t covers, int taps) {
    std::string text = define("CASCADES", static_cast<int>(cascades)) +
                       define("COVERS", static_cast<int>(covers)) + define("TAPS", taps) +
                       define("TILES", kSeedTiles);
    int view = 0;
    for (const std::string_view name : kEnumWords<View>) {
        text += define("VIEW_" + std::string(name), view++);
    }
    return text;
}

}  // namespace ocean::preview
