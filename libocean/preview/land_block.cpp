// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "land_block.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "sky.hpp"
#include "view_table.hpp"

namespace ocean::preview {
namespace {

// The belt of the snow line, in cover_relief(): half its width, its rise on slopes that face the
// sun and on crests. Of a land with an rms of 350 m: 140 m, 220 m and 260 m.
constexpr float kSnowBelt = 0.4f;
constexpr float kSunnyRise = 0.63f;
constexpr float kWornRise = 0.74f;

// Spacings before the range where odd vertices snap and their morph ends, as in land_vertex().
constexpr double kSnap = 0.25;
constexpr double kFlat = 1.75;

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
std::array<double, 2> default_range(ViewRange range, const DrawnLand& land) {
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

void set_map(LandBlock& b, const DrawnLand& land, const Camera& camera) {
    const LandImage& image = *land.image;
    const double texel = texel_of(land);
    const double east = camera.eye[0] - image.origin[0], north = camera.eye[1] - image.origin[1];
    double u = east / image.period, v = north / image.period;
    if (image.wraps) {
        u = fraction(u);
        v = fraction(v);
    }
    b.tile = glm::vec4(u, v, 1.0 / image.period, texel);
    b.texel = glm::vec4(fraction(east / texel), fraction(north / texel), 0.0, 0.0);
    b.eye_texel =
        glm::ivec4(whole(east / texel), whole(north / texel), image.resolution, image.wraps);
    b.heights = glm::vec4(land.mean, cover_relief(land), land.heights[0], land.heights[1]);
}

/// Sets the lattice of the vertices and their morph: see morph_at() and land_vertex() of
/// ocean/internal/land_quadtree.hpp.
void set_lattice(LandBlock& b, const DrawnLattice& lattice, const Camera& camera) {
    const QuadtreeSettings& settings = lattice.settings;
    const auto beside = [&](std::size_t axis) {
        return camera.eye[axis] - static_cast<double>(lattice.snapped[axis]) * settings.spacing;
    };
    b.lattice = glm::vec4(beside(0), beside(1), settings.spacing, lattice.height * lattice.height);
    const double begin = settings.morph_start * settings.range, end = settings.range - kFlat;
    b.morph = glm::vec4(begin * begin, 1.0 / (end * end - begin * begin), settings.range - kSnap,
                        settings.levels - 1);
    constexpr float kNoEdge = 1e30f;
    b.edge = glm::vec4(-kNoEdge, -kNoEdge, kNoEdge, kNoEdge);
    if (!settings.edge) return;
    const auto& [low, high] = *settings.edge;
    b.edge = glm::vec4(low[0] - camera.eye[0], low[1] - camera.eye[1], high[0] - camera.eye[0],
                       high[1] - camera.eye[1]);
}

/// Sets the sizes of the cover noise, in equal ratios from a part of the tile to less than a cell
/// of the terrain, and those of the relief of covers.
void set_cover(LandBlock& b, const DrawnLand& land, const Camera& camera) {
    const double largest = land.image->period / 24.0;
    const double smallest = std::min(0.1 * land.cell, kSmallestCover);
    for (std::size_t i = 0; i < kNoiseSizes; ++i) {
        const double share = static_cast<double>(i) / (kCoverSizes - 1);
        const bool is_relief = i >= kCoverSizes;
        const double size = is_relief ? kReliefWaves[i - kCoverSizes]
                                      : largest * std::pow(smallest / largest, share);
        double x = camera.eye[0] / size, y = camera.eye[1] / size;
        // As turned by the shader.
        if (is_relief) std::tie(x, y) = std::pair(0.8 * x + 0.6 * y, 0.8 * y - 0.6 * x);
        b.cover[i] = glm::vec4(fraction(x), fraction(y), 1.0 / size, size);
        b.cover_cell[i] = glm::ivec4(whole(x), whole(y), 0, 0);
    }
}

}  // namespace

LandBlock make_land_block(const DrawnLand& land, const DrawnLattice& lattice,
                          const PictureFrame& frame, int shadow_steps) {
    const Camera& camera = frame.camera;
    const Look& look = frame.look;
    const DrawOptions& options = frame.options;
    LandBlock b;
    set_lattice(b, lattice, camera);
    const CoverLines lines = cover_lines(land, look.snow_line);
    b.water =
        glm::vec4(land.water_level.value_or(0.0), land.water_level ? 1.0 : 0.0, lines.trees, 0.0);
    set_map(b, land, camera);
    const bool is_given = options.range[0] != 0.0 || options.range[1] != 0.0;
    const auto [low, high] =
        is_given ? options.range : default_range(row_of(options.view).range, land);
    b.range = glm::vec4(low, high, land.cell, 0.0);
    b.snow = glm::vec4(lines.snow, glm::vec3(kSnowBelt, kSunnyRise, kWornRise) *
                                       static_cast<float>(cover_relief(land)));
    const glm::dvec3 sun(make_sky(look).sun_direction);
    const double rise = std::max(sun.z / std::max(std::hypot(sun.x, sun.y), 1e-6), kMinRise);
    const double reach = std::min((land.heights[1] - land.heights[0]) / rise, land.image->period);
    b.shadow = glm::vec4(shadow_steps, std::max(reach, 2.0 * texel_of(land)), 0.0, 0.0);
    b.colours = glm::ivec4(static_cast<int>(look.land_colours), options.wireframe ? 1 : 0, 0, 0);
    set_cover(b, land, camera);
    return b;
}

}  // namespace ocean::preview
