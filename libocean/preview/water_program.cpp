// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "water_program.hpp"

#include <algorithm>

#include "ocean/error.hpp"
#include "ocean/internal/foam_texture.hpp"
#include "view_table.hpp"

namespace ocean::preview {
namespace {

constexpr int kMapsOfCascades = 3;  // displacement, gradients and moments
constexpr int kLaceUnits = static_cast<int>(kFoamTextures.size()) + 1;

constexpr int kCoastUnits = 4;  // shape, gradients, moments and traces

using Counts = std::array<std::size_t, kMaxArrays>;

std::string define(const std::string& name, std::size_t value) {
    return "#define " + name + " " + std::to_string(value) + "\n";
}

int arrays(const Counts& counts) {
    return static_cast<int>(std::ranges::count_if(counts, [](std::size_t n) { return n > 0; }));
}

std::size_t sum(const Counts& counts) {
    return counts[0] + counts[1];
}

}  // namespace

std::string water_defines(const WaterVariant& variant, int taps) {
    return define("CASCADES", sum(variant.cascades)) + define("SPLIT", variant.cascades[0]) +
           define("MAPS", static_cast<std::size_t>(arrays(variant.cascades))) +
           define("COVERS", variant.covers) + define("LACE", variant.lace ? 1 : 0) +
           define("DETAIL", sum(variant.tiles)) + define("TILE_SPLIT", variant.tiles[0]) +
           define("TILE_MAPS", static_cast<std::size_t>(arrays(variant.tiles))) +
           define("BELOW", variant.below ? 1 : 0) + define("COAST", variant.coast ? 1 : 0) +
           define("TAPS", static_cast<std::size_t>(taps)) + define("TILES", kSeedTiles) +
           view_defines(SceneKind::sea);
}

int texture_units(const WaterVariant& variant) {
    return 1 + kMapsOfCascades * arrays(variant.cascades) + static_cast<int>(variant.covers) +
           (variant.lace ? kLaceUnits : 0) + arrays(variant.tiles) +
           (variant.coast ? kCoastUnits : 0);
}

LeftOut fit_to_units(WaterVariant& variant, int available) {
    LeftOut out{.required_units = texture_units(variant), .available_units = available};
    WaterVariant without_detail = variant;
    without_detail.tiles = {};
    if (variant.lace && texture_units(without_detail) > available) {
        variant.lace = false;
        out.foam_pattern = true;
    }
    if (arrays(variant.tiles) > 0 && texture_units(variant) > available) {
        variant.tiles = {};
        out.near_detail = true;
    }
    if (texture_units(variant) <= available) return out;
    throw Error(ErrorKind::no_gpu, "the water needs " + std::to_string(texture_units(variant)) +
                                       " texture units in a fragment shader; this driver has " +
                                       std::to_string(available));
}

}  // namespace ocean::preview
