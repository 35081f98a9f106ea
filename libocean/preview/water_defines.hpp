// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// What water.vert, water.frag, seed.vert and seed.frag of shaders/preview are compiled with.
#pragma once

#include <cstddef>
#include <string>
#include <utility>

#include "ocean/preview/picture.hpp"

namespace ocean::preview {

/// Of the look `seed`, along each side, around the origin of the world.
inline constexpr int kSeedTiles = 10;

inline std::string define(const std::string& name, int value) {
    return "#define " + name + " " + std::to_string(value) + "\n";
}

/// taps: of a footprint; 0: the driver's filter.
inline std::string water_defines(std::size_t cascades, std::size_t covers, int taps) {
    const std::pair<const char*, View> views[] = {
        {"SHADED", View::shaded},
        {"HEIGHT", View::height},
        {"DISPLACEMENT_X", View::displacement_x},
        {"DISPLACEMENT_Y", View::displacement_y},
        {"NORMAL", View::normal},
        {"SLOPE", View::slope},
        {"JACOBIAN", View::jacobian},
        {"WHITECAP", View::whitecap},
        {"FOAM", View::foam},
        {"NUMBERS", View::numbers},
    };
    std::string text = define("CASCADES", static_cast<int>(cascades)) +
                       define("COVERS", static_cast<int>(covers)) + define("TAPS", taps) +
                       define("TILES", kSeedTiles);
    for (const auto& [name, view] : views) {
        text += define(std::string("VIEW_") + name, static_cast<int>(view));
    }
    return text;
}

}  // namespace ocean::preview
