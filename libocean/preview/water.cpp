// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "water.hpp"

#include <algorithm>
#include <cmath>

#include "frame_block.hpp"
#include "ocean/error.hpp"
#include "texture_units.hpp"
#include "view_table.hpp"
#include "wave/wave.hpp"

namespace ocean::preview {
namespace {

using wave::double_precision::horizon_distance;

int available_units(const RendererOptions& options) {
    GLint units = 16;
    glGetIntegerv(GL_MAX_TEXTURE_IMAGE_UNITS, &units);
    return options.max_texture_units > 0 ? std::min(units, options.max_texture_units) : units;
}

/// Calls visit(number of the array, its first item) for each run of items that lie in one array.
template <typename Items, typename Array, typename Visit>
void visit_arrays(const Items& items, Array&& array, Visit&& visit) {
    std::size_t number = 0;
    for (std::size_t i = 0; i < items.size(); ++i) {
        if (i > 0 && array(items[i]) == array(items[i - 1])) continue;
        visit(number++, items[i]);
    }
}

/// Returns how many items lie in each array. Throws Error invalid_value for more than kMaxArrays.
template <typename Items, typename Array>
std::array<std::size_t, kMaxArrays> array_sizes(const Items& items, Array&& array) {
    std::array<std::size_t, kMaxArrays> sizes{};
    std::size_t number = 0;
    for (std::size_t i = 0; i < items.size(); ++i) {
        if (i > 0 && !(array(items[i]) == array(items[i - 1]))) ++number;
        if (number >= kMaxArrays) {
            throw Error(ErrorKind::invalid_value, "a picture shows the maps of at most two seas");
        }
        ++sizes[number];
    }
    return sizes;
}

const gl::CascadeArrays& maps_of(const DrawnCascade& cascade) {
    return cascade.maps;
}
unsigned map_of(const DrawnTile& tile) {
    return tile.texture;
}

/// Shortest distance of the eye from a surface that may lie far above still water [m].
constexpr double kLeastDistance = 0.1;

/// Returns how far the drawn surface is from its labels, and where it ends.
Reach reach_of(const DrawnSea& sea, double eye_height) {
    const double crest = std::max(1.5 * sea.significant_wave_height, 0.1);
    const double highest = sea.coast ? std::max(crest, sea.coast->highest) : crest;
    return {.sideways = 1.5 * sea.choppiness * sea.significant_wave_height,
            .up = highest,
            .farthest = 1.05 * (horizon_distance(eye_height) + horizon_distance(crest))};
}

glm::dvec3 eye_of(const Camera& camera) {
    return {camera.eye[0], camera.eye[1], camera.eye[2]};
}

}  // namespace

Water::Water(const RendererOptions& options)
    : taps_(filter_taps(options)),
      available_units_(available_units(options)),
      clipmap_(options.cells),
      lace_maps_(!options.live, options.kept_textures),
      options_(options),
      sampler_(make_footprint_sampler(taps_)),
      block_(BlockBinding::water) {}

void Water::show(const DrawnSea& sea) {
    if (sea.cascades.size() > kMaxCascades || sea.covers.size() > 2 ||
        sea.tiles.size() > kMaxTiles) {
        throw Error(ErrorKind::invalid_value, "a picture shows at most two seas");
    }
    sea_ = &sea;
}

Pending Water::pending() const {
    return lace_used_ ? lace_maps_.pending() : Pending::nothing;
}

double Water::farthest(const PictureFrame& frame) const {
    if (is_seed(frame.look, frame.options)) {
        return glm::length(eye_of(frame.camera)) + kSeedTiles * sea_->period;
    }
    const double open = reach_of(*sea_, frame.camera.eye[2]).farthest;
    if (!sea_->coast) return open;
    return std::max(open, CoastGround::farthest(*sea_->coast, frame));
}

void Water::draw(const PictureFrame& frame) {
    block_.set(make_water_block(*sea_, frame.camera, frame.look, frame.options));
    left_out_ = {};
    lace_used_ = false;
    if (is_seed(frame.look, frame.options)) {
        draw_seed(frame);
    } else {
        draw_clipmap(frame);
    }
}

WaterVariant Water::variant(const PictureFrame& frame) const {
    const ViewRow& view = row_of(frame.options.view);
    WaterVariant variant;
    variant.cascades = array_sizes(sea_->cascades, maps_of);
    variant.covers = sea_->covers.size();
    variant.coast = sea_->coast != nullptr && !sea_->coast->windows.empty();
    variant.lace =
        view.pattern == FoamPattern::always ||
        (view.pattern == FoamPattern::if_visible && frame.look.foam_amount > 0.0 && sea_->has_foam);
    if (view.detail == NearDetail::yes && frame.options.cascade < 0) {
        variant.tiles = array_sizes(sea_->tiles, map_of);
    }
    // No crest is as high as two significant wave heights.
    variant.below = frame.options.view == View::shaded &&
                    frame.camera.eye[2] < 2.0 * sea_->significant_wave_height;
    return variant;
}

gl::ShaderProgram& Water::program(Programs& known, const std::string& name,
                                  const WaterVariant& variant) {
    auto found = known.find(variant);
    if (found == known.end()) {
        gl::ShaderProgram made({{GL_VERTEX_SHADER, "preview/" + name + ".vert"},
                                {GL_FRAGMENT_SHADER, "preview/" + name + ".frag"}},
                               water_defines(variant, taps_));
        found = known.emplace(variant, std::move(made)).first;
    }
    gl::ShaderProgram& program = found->second;
    program.use();
    PictureFrame::attach(program.name());
    attach_block(program.name(), "WaterBlock", BlockBinding::water);
    attach_block(program.name(), "CoastBlock", BlockBinding::coast);
    return program;
}

void Water::bind_maps(gl::ShaderProgram& program, TextureUnits& units,
                      const WaterVariant& variant) {
    // Textures are uploaded through the current unit, which may be the sky's.
    glActiveTexture(GL_TEXTURE0 + PictureFrame::kSkyUnit + 1);
    const bool lace_is_ready = variant.lace && lace_maps_.ready();
    visit_arrays(sea_->cascades, maps_of, [&](std::size_t a, const DrawnCascade& cascade) {
        const std::string number = "[" + std::to_string(a) + "]";
        const auto bind = [&](const char* name, unsigned texture, GLuint sampler) {
            units.bind(program, name + number, GL_TEXTURE_2D_ARRAY, texture, sampler);
        };
        bind("displacement_maps", cascade.maps.displacement, sampler_.name());
        bind("gradient_maps", cascade.maps.gradients, sampler_.name());
        bind("moment_maps", cascade.maps.moments, sampler_.name());
        bind("shape_maps", cascade.maps.displacement, 0);
    });
    for (std::size_t v = 0; v < sea_->covers.size(); ++v) {
        units.bind(program, "cover_map[" + std::to_string(v) + "]", GL_TEXTURE_2D,
                   sea_->covers[v].texture, sampler_.name());
    }
    if (variant.lace) bind_lace(program, units, lace_is_ready);
    if (variant.coast) bind_coast(program, units, *sea_->coast, sampler_.name());
    if (variant.tiles[0] == 0) return;
    visit_arrays(sea_->tiles, map_of, [&](std::size_t a, const DrawnTile& tile) {
        units.bind(program, "tile_maps[" + std::to_string(a) + "]", GL_TEXTURE_2D_ARRAY,
                   tile.texture);
    });
}

void Water::bind_lace(gl::ShaderProgram& program, TextureUnits& units, bool ready) {
    // One program serves before and after its textures are ready: compiling another one would stop
    // a window that is in use.
    program.set("lace_ready", ready ? 1 : 0);
    const auto bind = [&](const char* name, unsigned texture) {
        units.bind(program, name, GL_TEXTURE_2D, ready ? texture : sea_->covers[0].texture);
    };
    bind("lace_map", lace_maps_.texture(FoamTextureKind::lace));
    bind("bubble_map", lace_maps_.texture(FoamTextureKind::bubbles));
    bind("streak_map", lace_maps_.texture(FoamTextureKind::streaks));
    bind("lace_shares", lace_maps_.shares());
    lace_used_ = true;
}

void Water::draw_seed(const PictureFrame& frame) {
    const WaterVariant plain{.cascades = array_sizes(sea_->cascades, maps_of),
                             .covers = sea_->covers.size()};
    gl::ShaderProgram& seed = program(seeds_, "seed", plain);
    TextureUnits units(PictureFrame::kSkyUnit + 1);
    bind_maps(seed, units, plain);
    seed_mesh_.draw(seed, eye_of(frame.camera), sea_->period, finest_texel(*sea_));
}

void Water::draw_clipmap(const PictureFrame& frame) {
    // Water first: it hides its bed.
    if (sea_->coast) {
        if (!coast_) coast_.emplace(options_);
        coast_->prepare(*sea_->coast, frame);
    }
    WaterVariant fitting = variant(frame);
    left_out_ = fit_to_units(fitting, available_units_);
    gl::ShaderProgram& water = program(waters_, "water", fitting);
    TextureUnits units(PictureFrame::kSkyUnit + 1);
    bind_maps(water, units, fitting);
    if (frame.options.shaded_samples > 1) glEnable(GL_SAMPLE_SHADING);
    glMinSampleShading(1.0f);
    const double finest = std::exp2(std::floor(std::log2(finest_texel(*sea_))));
    glm::dvec3 eye = eye_of(frame.camera);
    if (sea_->coast)
        eye.z = std::max(eye.z - sea_->coast->surface_at(eye.x, eye.y), kLeastDistance);
    if (fitting.coast) glEnable(GL_CLIP_DISTANCE0);
    clipmap_.draw(water, eye, finest,
                  Frustum(frame.projection.clip_from_world, frame.camera.eye[2]),
                  reach_of(*sea_, frame.camera.eye[2]), frame.options.wireframe);
    glDisable(GL_CLIP_DISTANCE0);
    if (sea_->coast && sea_->coast->bed && frame.options.ground &&
        row_of(frame.options.view).use == ViewUse::picture) {
        coast_->draw(*sea_->coast, frame, clipmap_, eye, finest);
    }
    glDisable(GL_SAMPLE_SHADING);
}

}  // namespace ocean::preview
