// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "land_block.hpp"

#include <algorithm>
#include <cmath>

#include "sky.hpp"
#include "view_table.hpp"

namespace ocean::preview {
namespace {

// The belt of the snow line, in rms heights: half its width, its rise on slopes that face the sun
// and on crests. Of a land with an rms of 350 m: 140 m, 220 m and 260 m.
constexpr float kSnowBelt = 0.4f;
constexpr float kSunnyRise = 0.63f;
constexpr float kWornRise = 0.74f;

constexpr double kSmallestCover = 0.4;  // [m]
constexpr double kMinRise = 0.01;       // of a line to the sun, where it is near the horizon

double fraction(double x) {
    return x - std::floor(x);
}

/// Returns the whole part, wrapped round where the eye is far away: the shader hashes its bits.
int whole(double x) {
    return static_cast<int>(static_cast<std::int64_t>(std::floor(x)));
}

/// Returns the lowest and the highest value that a view shows where DrawOptions give none.
std::array<double, 2> default_range(ViewRange range, const ShownLand& land) {
    const double height = 2.0 * colour_scale(land);
    const double slope = std::max(4.0 * std::sqrt(0.5) * land.rms_slope, 1e-6);
    switch (range) {
        case ViewRange::height:
            return {land.mean - height, land.mean + height};
        case ViewRange::slope:
            return {-slope, slope};
        case ViewRange::jacobian:
            break;
    }
    return {0.0, 1.0};
}

void set_map(LandBlock& b, const ShownLand& land, const Camera& camera) {
    const double period = land.image->period, texel = texel_of(land);
    const double u = camera.eye[0] / period, v = camera.eye[1] / period;
    b.tile = glm::vec4(fraction(u), fraction(v), 1.0 / period, texel);
    const double x = camera.eye[0] / texel, y = camera.eye[1] / texel;
    b.texel = glm::vec4(fraction(x), fraction(y), 0.0, 0.0);
    b.eye_texel = glm::ivec4(whole(x), whole(y), land.image->resolution, 0);
    b.heights = glm::vec4(land.mean, colour_scale(land), land.heights[0], land.heights[1]);
}

/// Sets the sizes of the cover noise, in equal ratios from a part of the tile to less than a cell
/// of the terrain.
void set_cover(LandBlock& b, const ShownLand& land, const Camera& camera) {
    const double largest = land.image->period / 24.0;
    const double smallest = std::min(0.1 * land.cell, kSmallestCover);
    for (std::size_t i = 0; i < kCoverSizes; ++i) {
        const double share = static_cast<double>(i) / (kCoverSizes - 1);
        const double size = largest * std::pow(smallest / largest, share);
        const double x = camera.eye[0] / size, y = camera.eye[1] / size;
        b.cover[i] = glm::vec4(fraction(x), fraction(y), 1.0 / size, size);
        b.cover_cell[i] = glm::ivec4(whole(x), whole(y), 0, 0);
    }
}

}  // namespace

LandBlock make_land_block(const ShownLand& land, const Camera& camera, const Look& look,
                          const DrawOptions& options, int shadow_steps) {
    LandBlock b;
    set_map(b, land, camera);
    const bool is_given = options.range[0] != 0.0 || options.range[1] != 0.0;
    const auto [low, high] =
        is_given ? options.range : default_range(row_of(options.view).range, land);
    b.range = glm::vec4(low, high, land.cell, 0.0);
    const double line = look.snow_line.value_or(default_snow_line(land));
    b.snow = glm::vec4(
        line, glm::vec3(kSnowBelt, kSunnyRise, kWornRise) * static_cast<float>(colour_scale(land)));
    const glm::dvec3 sun(make_sky(look).sun_direction);
    const double rise = std::max(sun.z / std::max(std::hypot(sun.x, sun.y), 1e-6), kMinRise);
    const double reach = std::min((land.heights[1] - land.heights[0]) / rise, land.image->period);
    b.shadow = glm::vec4(shadow_steps, std::max(reach, 2.0 * texel_of(land)), 0.0, 0.0);
    b.colours = glm::ivec4(static_cast<int>(look.land_colours));
    set_cover(b, land, camera);
    return b;
}

}  // namespace ocean::preview
