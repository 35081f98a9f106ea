// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "water_block.hpp"

#include <algorithm>
#include <cmath>

#include "frame_block.hpp"
#include "ocean/internal/foam_texture.hpp"
#include "ocean/internal/water_types.hpp"
#include "view_table.hpp"
#include "wave/wave.hpp"

namespace ocean::preview {
namespace {

/// Periods of the grid of copies in a tile.
constexpr double kTileScale = [] {
    using wave::double_precision::real;
    return slope_tile_triangles / copy_triangles;
}();

double fraction(double x) {
    return x - std::floor(x);
}

/// Returns the lowest and the highest value that a view shows where DrawOptions give none.
std::array<double, 2> default_range(ViewRange range, const DrawnSea& sea) {
    const double height = std::max(sea.significant_wave_height, 1e-3);
    const double slope = 4.0 * std::sqrt(0.5 * sea.mean_square_slope);
    switch (range) {
        case ViewRange::height:
            return {-height, height};
        case ViewRange::slope:
            return {-slope, slope};
        case ViewRange::jacobian:
            return {0.0, 2.0};
    }
    return {};
}

void set_waves(WaterBlock& b, const DrawnSea& sea, const Look& look, const DrawOptions& options) {
    const Rgb crest = water_type(look.water_type).crest_colour();
    b.waves = glm::vec4(sea.choppiness, sea.significant_wave_height,
                        options.cascade < 0 ? sea.mean_square_slope : 0.0, 0.0);
    b.foam = glm::vec4(sea.foam_threshold, sea.foam_width, 0.0, look.foam_amount);
    b.crest = glm::vec4(crest[0], crest[1], crest[2], look.crest_light);
    const bool is_given = options.range[0] != 0.0 || options.range[1] != 0.0;
    const auto [low, high] =
        is_given ? options.range : default_range(row_of(options.view).range, sea);
    b.range = glm::vec4(low, high, 0.0, 0.0);
}

void set_copies(WaterBlock& b, const DrawnSea& sea, const Camera& camera, bool are_shown) {
    const double u = camera.eye[0] / sea.period, v = camera.eye[1] / sea.period;
    b.period = glm::vec4(1.0 / sea.period, are_shown ? 1.0 : 0.0, 0.0, 0.0);
    const auto grid = wave::double_precision::copy_grid(u, v);
    b.grid_place = glm::vec4(fraction(grid.x), fraction(grid.y), 0.0, 0.0);
    b.grid_cell = glm::ivec4(static_cast<int>(std::floor(grid.x)),
                             static_cast<int>(std::floor(grid.y)), 0, 0);
}

/// shown: the number of the cascade that is shown alone, or -1 for all.
void set_cascade(WaterBlock& b, std::size_t c, const DrawnCascade& cascade, const Camera& camera,
                 int shown) {
    const bool is_shown = shown < 0 || cascade.number == shown;
    b.part[c] = glm::vec4(is_shown ? cascade.weight : 0.0, cascade.sea_period / cascade.period,
                          static_cast<double>(cascade.layer), 0.0);
    b.cascade[c] = glm::vec4(fraction(camera.eye[0] / cascade.period),
                             fraction(camera.eye[1] / cascade.period), 1.0 / cascade.period,
                             cascade.period / cascade.maps.resolution);
}

/// Far from the origin a label in tiles has no fraction left in float.
void set_lace(WaterBlock& b, std::size_t v, const DrawnCover& cover, const Camera& camera) {
    const double tile = foam_texture_info(FoamTextureKind::lace).period;
    const double bubble = tile / foam_texture_info(FoamTextureKind::bubbles).period;
    const double streak = tile / foam_texture_info(FoamTextureKind::streaks).period;
    const double c = std::cos(cover.direction) / tile, s = std::sin(cover.direction) / tile;
    const double along = camera.eye[0] * c + camera.eye[1] * s;
    const double across = camera.eye[1] * c - camera.eye[0] * s;
    const double net = along / cover.stretch;
    b.lace[v] = glm::vec4(c, s, 1.0 / cover.stretch, cover.streaks);
    b.lace_net[v] =
        glm::vec4(fraction((3.0 * net + across) / 11.0), fraction((3.0 * across - net) / 11.0),
                  fraction(net), fraction(across));
    b.lace_more[v] = glm::vec4(fraction(bubble * along), fraction(bubble * across),
                               fraction(streak * along), fraction(streak * across));
}

void set_cover(WaterBlock& b, std::size_t v, const DrawnCover& cover, const Camera& camera) {
    b.cover[v] =
        glm::vec4(fraction(camera.eye[0] / cover.period), fraction(camera.eye[1] / cover.period),
                  1.0 / cover.period, 1.0 / cover.resolution);
    b.cover_share[static_cast<int>(v)] = static_cast<float>(cover.share);
    set_lace(b, v, cover, camera);
}

void set_tile(WaterBlock& b, std::size_t d, const DrawnTile& tile, const Camera& camera) {
    const double u = camera.eye[0] / tile.tile, v = camera.eye[1] / tile.tile;
    const double half = 0.5 / tile.samples;  // a sample lies in the middle of its texel
    b.tile[d] = glm::vec4(fraction(u) + half, fraction(v) + half, 1.0 / tile.tile, tile.weight);
    const auto grid = wave::double_precision::copy_grid(kTileScale * u, kTileScale * v);
    b.tile_grid[d] =
        glm::vec4(fraction(grid.x), fraction(grid.y), tile.shortest_wave, tile.longest_wave);
    // Far away they wrap round: the shader hashes their bits.
    const auto cell = [](double x) {
        return static_cast<int>(static_cast<std::int64_t>(std::floor(x)));
    };
    b.tile_cell[d] = glm::ivec4(cell(grid.x), cell(grid.y), tile.layer, tile.samples);
    for (std::size_t level = 0; level < kTileLevels; ++level) {
        b.tile_read[2 * d + level / 4][static_cast<int>(level % 4)] =
            static_cast<float>(tile.read[level]);
    }
    b.tile_variance[d] = glm::vec4(tile.variance.x, tile.variance.y, tile.variance.xy, 0.0);
}

}  // namespace

WaterBlock make_water_block(const DrawnSea& sea, const Camera& camera, const Look& look,
                            const DrawOptions& options) {
    WaterBlock b;
    set_waves(b, sea, look, options);
    set_copies(b, sea, camera, !look.repeats && !is_seed(look, options));
    for (std::size_t c = 0; c < sea.cascades.size(); ++c) {
        set_cascade(b, c, sea.cascades[c], camera, options.cascade);
    }
    for (std::size_t v = 0; v < sea.covers.size(); ++v) set_cover(b, v, sea.covers[v], camera);
    for (std::size_t d = 0; d < sea.tiles.size(); ++d) set_tile(b, d, sea.tiles[d], camera);
    return b;
}

}  // namespace ocean::preview
