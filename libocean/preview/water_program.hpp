// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The variants of the water's programs: the defines that water.vert, water.frag, seed.vert and
// seed.frag of shaders/preview are compiled with, and the texture units that a variant takes.
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <string>

#include "ocean/internal/preview/renderer.hpp"

namespace ocean::preview {

/// Tiles along each side of the look `seed`, around the origin of the world.
inline constexpr int kSeedTiles = 10;

/// Array textures of one kind: of one sea, or of two that are faded into each other.
inline constexpr std::size_t kMaxArrays = 2;

struct WaterVariant {
    std::array<std::size_t, kMaxArrays> cascades{};  // in each array of maps
    std::size_t covers = 0;
    bool lace = false;                            // the foam has its pattern
    std::array<std::size_t, kMaxArrays> tiles{};  // in each array of slope tiles
    bool below = false;                           // the eye may be under water
    bool coast = false;                           // windows of a coast lie over the maps

    auto operator<=>(const WaterVariant&) const = default;
};

/// taps: samples along a footprint; 0: the driver's anisotropic filter.
std::string water_defines(const WaterVariant& variant, int taps);

/// Returns the texture units that the variant's fragment shader takes, the sky's included.
int texture_units(const WaterVariant& variant);

/// Leaves out the parts that do not fit into so many units: near detail, and if that is not enough
/// the pattern of the foam. Returns what was left out. Throws Error no_gpu if the rest does not fit
/// either.
LeftOut fit_to_units(WaterVariant& variant, int available);

}  // namespace ocean::preview
