// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "ocean/preview/renderer.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <map>
#include <string>

#include "angles.hpp"
#include "clipmap.hpp"
#include "frame_block.hpp"
#include "lace_maps.hpp"
#include "ocean/error.hpp"
#include "ocean/gl/context.hpp"
#include "ocean/gl/shader_program.hpp"
#include "ocean/water_types.hpp"
#include "seed_mesh.hpp"
#include "sky.hpp"
#include "sky_map.hpp"
#include "water_defines.hpp"
#include "wave/wave.hpp"

namespace ocean::preview {
namespace {

using wave::double_precision::earth_radius, wave::double_precision::horizon_distance;

constexpr GLuint kFrameBinding = 0;
/// Periods of the grid of copies in a tile.
constexpr double kTileScale = [] {
    using wave::double_precision::real;
    return slope_tile_triangles / copy_triangles;
}();

double fraction(double x) {
    return x - std::floor(x);
}

/// Fields are shown on the clipmap whatever the look.
bool is_seed(const Look& look, const DrawOptions& options) {
    return look.kind == LookKind::seed && options.view == View::shaded;
}

std::array<double, 2> usual_range(ViewRange range, const ShownSea& sea) {
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

glm::vec4 with(const glm::vec3& rgb, double w) {
    return {rgb, static_cast<float>(w)};
}

/// llvmpipe 22.3 does not come back from compiling its own filter of long footprints.
int filter_taps(const RendererOptions& options) {
    if (options.taps > 0) return options.taps;
    const bool fits =
        epoxy_has_gl_extension("GL_EXT_texture_filter_anisotropic") || epoxy_gl_version() >= 46;
    return fits && !gl::context_info().software ? 0 : 2;
}

/// What has another value for each frame's view.
struct Projection {
    glm::mat4 clip_from_world;  // of places relative to the eye
    double pixel_angle;         // between the middle pixels
    bool flat = false;          // no perspective, and with it its own depth
};

Projection perspective(const Camera& camera, int width, int height) {
    const double half = std::tan(0.5 * kRadians * camera.field_of_view);
    const double aspect = static_cast<double>(width) / height;
    const double h = kRadians * camera.heading, p = kRadians * camera.pitch;
    const glm::dvec3 ahead(std::cos(p) * std::cos(h), std::cos(p) * std::sin(h), std::sin(p));
    const glm::dvec3 up(-std::sin(p) * std::cos(h), -std::sin(p) * std::sin(h), std::cos(p));
    const glm::dmat4 view = glm::lookAt(glm::dvec3(0.0), ahead, up);
    // Its depth is not used: water.vert makes a logarithmic one.
    const glm::dmat4 lens = glm::frustum(-half, half, -half / aspect, half / aspect, 1.0, 2.0);
    return {glm::mat4(lens * view), 2.0 * half / width};
}

}  // namespace

struct Renderer::Parts {
    explicit Parts(const RendererOptions& options)
        : after_stage(options.after_stage),
          clipmap(options.cells),
          taps(filter_taps(options)),
          lace_maps(!options.live) {
        sky = gl::ShaderProgram(
            {{GL_VERTEX_SHADER, "preview/sky.vert"}, {GL_FRAGMENT_SHADER, "preview/sky.frag"}}, "");
        no_vertices = gl::make_vertex_array();
        sampler = gl::generate<gl::Sampler, &glGenSamplers>();
        glSamplerParameteri(sampler.name(), GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
        glSamplerParameteri(sampler.name(), GL_TEXTURE_MAG_FILTER, GL_LINEAR);
        if (taps == 0) {
            glSamplerParameterf(sampler.name(), GL_TEXTURE_MAX_ANISOTROPY_EXT, 16.0f);
        }
        glGetIntegerv(GL_MAX_TEXTURE_IMAGE_UNITS, &texture_units);
        frame = gl::make_buffer();
        glBindBuffer(GL_UNIFORM_BUFFER, frame.name());
        glBufferData(GL_UNIFORM_BUFFER, sizeof(FrameBlock), nullptr, GL_DYNAMIC_DRAW);
    }

    gl::AfterStage after_stage;
    Clipmap clipmap;
    int taps;  // 0: the driver's filter fits the footprints
    gl::ShaderProgram sky;
    SkyMap sky_map;
    LaceMaps lace_maps;
    using Programs = std::map<WaterParts, gl::ShaderProgram>;
    Programs waters, seeds;
    SeedMesh seed_mesh;
    gl::VertexArray no_vertices;
    gl::Sampler sampler;
    gl::Buffer frame;
    GLint texture_units = 16;
    GLint units_used = 0;    // by the last program
    bool lace_used = false;  // by the last picture

    /// Of preview/NAME.vert and preview/NAME.frag.
    gl::ShaderProgram& program(Programs& known, const std::string& name, const WaterParts& parts) {
        const auto found = known.find(parts);
        if (found != known.end()) return found->second;
        gl::ShaderProgram made({{GL_VERTEX_SHADER, "preview/" + name + ".vert"},
                                {GL_FRAGMENT_SHADER, "preview/" + name + ".frag"}},
                               water_defines(parts, taps));
        return known.emplace(parts, std::move(made)).first->second;
    }

    WaterParts parts_of(const ShownSea& sea, const Camera& camera, const Look& look,
                        const DrawOptions& options) {
        WaterParts parts{sea.cascades.size(), sea.covers.size()};
        const ViewRow& view = row_of(options.view);
        const bool seen =
            view.pattern == FoamPattern::always ||
            (view.pattern == FoamPattern::if_visible && look.foam_amount > 0.0 && sea.has_foam);
        const std::size_t others = 1 + 3 * parts.cascades + parts.covers;
        const bool room =
            others + kFoamTextures.size() + 1 <= static_cast<std::size_t>(texture_units);
        parts.lace = seen && room;
        const bool slopes = view.detail == NearDetail::yes;
        const std::size_t before = others + (parts.lace ? kFoamTextures.size() + 1 : 0);
        const std::size_t tiles = std::min(sea.tiles.size(), kMostTiles);
        const bool fits = before + tiles <= static_cast<std::size_t>(texture_units);
        if (slopes && fits && options.cascade < 0) parts.tiles = tiles;
        // No crest is as high as that.
        parts.below =
            options.view == View::shaded && camera.eye[2] < 2.0 * sea.significant_wave_height;
        return parts;
    }

    FrameBlock block(const ShownSea& sea, const Camera& camera, const Look& look,
                     const DrawOptions& options, const Projection& projection) {
        const Sky colours = make_sky(look);
        const WaterType& type = water_type(look.water_type);
        const Rgb albedo = type.water_leaving_albedo();
        FrameBlock b;
        b.clip_from_world = projection.clip_from_world;
        b.world_from_clip = glm::inverse(projection.clip_from_world);
        b.eye = with(glm::vec3(0.0f, 0.0f, static_cast<float>(camera.eye[2])), 1.0);
        b.sun = with(colours.sun_direction, colours.sun_shown);
        b.sun_colour = with(colours.sun_colour, 0.0);
        b.sky_low = with(colours.low, horizon_distance(camera.eye[2]) / earth_radius());
        b.sky_middle = with(colours.middle, colours.mapped);
        b.sky_high = with(colours.high, colours.turn);
        b.sky_shadow = with(colours.shadow, colours.dusk);
        b.sky_light = with(colours.light, 0.0);
        b.water = with(glm::vec3(albedo[0], albedo[1], albedo[2]), kWaterIor);
        const Rgb crest = type.crest_colour();
        b.crest = with(glm::vec3(crest[0], crest[1], crest[2]), look.crest_light);
        for (int c = 0; c < 3; ++c) {
            // Most of what is scattered goes on ahead.
            const auto channel = static_cast<std::size_t>(c);
            b.loss[c] =
                static_cast<float>(type.absorption[channel] + 0.1 * type.scattering[channel]);
        }
        const bool all = options.cascade < 0;
        b.waves = glm::vec4(sea.choppiness, sea.significant_wave_height,
                            all ? sea.mean_square_slope : 0.0, 0.0);
        b.foam = glm::vec4(sea.foam_threshold, sea.foam_width, 0.0, look.foam_amount);
        const double u = camera.eye[0] / sea.period, v = camera.eye[1] / sea.period;
        b.period = glm::vec4(1.0 / sea.period, look.repeats ? 0.0 : 1.0, 0.0, 0.0);
        if (is_seed(look, options)) {
            b.eye.w = 0.0f;
            b.period.y = 0.0f;
            b.sky_low = with(kSeedFog, 0.0);
        }
        const auto grid = wave::double_precision::copy_grid(u, v);
        b.grid_place = glm::vec4(fraction(grid.x), fraction(grid.y), 0.0, 0.0);
        b.grid_cell = glm::ivec4(static_cast<int>(std::floor(grid.x)),
                                 static_cast<int>(std::floor(grid.y)), 0, 0);
        b.look = glm::vec4(look.exposure, look.visibility,
                           projection.pixel_angle / std::sqrt(options.shaded_samples),
                           options.linear ? 1.0 : 0.0);
        b.view = glm::ivec4(static_cast<int>(options.view));
        b.range = glm::vec4(options.range[0], options.range[1], 0.0, 0.0);
        if (options.range[0] == 0.0 && options.range[1] == 0.0) {
            const auto [low, high] = usual_range(row_of(options.view).range, sea);
            b.range = glm::vec4(low, high, 0.0, 0.0);
        }
        for (std::size_t c = 0; c < sea.cascades.size(); ++c) {
            const ShownCascade& cascade = sea.cascades[c];
            const bool shown = all || cascade.number == options.cascade;
            b.part[c] = glm::vec4(shown ? cascade.weight : 0.0, cascade.sea_period / cascade.period,
                                  0.0, 0.0);
            b.cascade[c] = glm::vec4(fraction(camera.eye[0] / cascade.period),
                                     fraction(camera.eye[1] / cascade.period), 1.0 / cascade.period,
                                     cascade.period / cascade.resolution);
        }
        for (std::size_t v = 0; v < sea.covers.size(); ++v) {
            const ShownCover& cover = sea.covers[v];
            b.cover[v] = glm::vec4(fraction(camera.eye[0] / cover.period),
                                   fraction(camera.eye[1] / cover.period), 1.0 / cover.period,
                                   1.0 / cover.resolution);
            b.cover_share[static_cast<int>(v)] = static_cast<float>(cover.share);
            place_lace(cover, camera, v, b);
        }
        for (std::size_t d = 0; d < std::min(sea.tiles.size(), kMostTiles); ++d) {
            place_tile(sea.tiles[d], camera, d, b);
        }
        return b;
    }

    static void place_tile(const ShownTile& tile, const Camera& camera, std::size_t d,
                           FrameBlock& b) {
        const double u = camera.eye[0] / tile.tile, v = camera.eye[1] / tile.tile;
        const double half = 0.5 / tile.samples;  // a sample lies in the middle of its texel
        b.tile[d] = glm::vec4(fraction(u) + half, fraction(v) + half, 1.0 / tile.tile, tile.weight);
        const auto grid = wave::double_precision::copy_grid(kTileScale * u, kTileScale * v);
        b.tile_grid[d] =
            glm::vec4(fraction(grid.x), fraction(grid.y), tile.shortest_wave, tile.longest_wave);
        // Far away they wrap round: what is hashed are bits.
        const auto cell = [](double x) {
            return static_cast<int>(static_cast<std::int64_t>(std::floor(x)));
        };
        b.tile_cell[d] = glm::ivec4(cell(grid.x), cell(grid.y), 0, 0);
        for (std::size_t level = 0; level < kTileLevels; ++level) {
            b.tile_read[2 * d + level / 4][static_cast<int>(level % 4)] =
                static_cast<float>(tile.read[level]);
        }
        b.tile_variance[d] = glm::vec4(tile.variance.x, tile.variance.y, tile.variance.xy, 0.0);
    }

    /// Far from the origin a label in tiles has no fraction left in float.
    static void place_lace(const ShownCover& cover, const Camera& camera, std::size_t v,
                           FrameBlock& b) {
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

    /// To unit 0.
    void bind_sky(gl::ShaderProgram& program) {
        program.set("sky_map", 0);
        glActiveTexture(GL_TEXTURE0);
        glBindTexture(GL_TEXTURE_2D, sky_map.texture());
        glBindSampler(0, 0);
    }

    void bind_maps(gl::ShaderProgram& program, const ShownSea& sea, const WaterParts& parts) {
        const bool lace_ready = parts.lace && lace_maps.ready();
        lace_used = parts.lace;
        bind_sky(program);
        GLint unit = 1;
        const auto bind = [&](const std::string& name, unsigned texture, GLuint filter) {
            program.set(name.c_str(), unit);
            glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
            glBindTexture(GL_TEXTURE_2D, texture);
            glBindSampler(static_cast<GLuint>(unit), filter);
            ++unit;
        };
        for (std::size_t c = 0; c < sea.cascades.size(); ++c) {
            const std::string number = "[" + std::to_string(c) + "]";
            bind("displacement_map" + number, sea.cascades[c].displacement, sampler.name());
            bind("gradient_map" + number, sea.cascades[c].gradients, sampler.name());
            bind("moment_map" + number, sea.cascades[c].moments, sampler.name());
            bind("shape_map" + number, sea.cascades[c].displacement, 0);
        }
        for (std::size_t v = 0; v < sea.covers.size(); ++v) {
            bind("cover_map[" + std::to_string(v) + "]", sea.covers[v].texture, sampler.name());
        }
        if (parts.lace) {
            // One program for before and after: another one would stop a window that is in use.
            program.set("lace_ready", lace_ready ? 1 : 0);
            const auto bind_lace = [&](const char* name, unsigned texture) {
                bind(name, lace_ready ? texture : sea.covers[0].texture, 0);
            };
            bind_lace("lace_map", lace_maps.texture(FoamTextureKind::lace));
            bind_lace("bubble_map", lace_maps.texture(FoamTextureKind::bubbles));
            bind_lace("streak_map", lace_maps.texture(FoamTextureKind::streaks));
            bind_lace("lace_shares", lace_maps.shares());
        }
        for (std::size_t d = 0; d < parts.tiles; ++d) {
            bind("tile_map[" + std::to_string(d) + "]", sea.tiles[d].texture, 0);
        }
        units_used = unit;
        glActiveTexture(GL_TEXTURE0);
    }

    void bind_frame(const gl::ShaderProgram& program) {
        const GLuint index = glGetUniformBlockIndex(program.name(), "Frame");
        if (index != GL_INVALID_INDEX) glUniformBlockBinding(program.name(), index, kFrameBinding);
    }

    void draw(const ShownSea& sea, const Camera& camera, const Look& look,
              const DrawOptions& options, const Projection& projection, bool background) {
        sky_map.hold(look.environment);
        const FrameBlock values = block(sea, camera, look, options, projection);
        glBindBuffer(GL_UNIFORM_BUFFER, frame.name());
        glBufferSubData(GL_UNIFORM_BUFFER, 0, sizeof(FrameBlock), &values);
        glBindBufferBase(GL_UNIFORM_BUFFER, kFrameBinding, frame.name());
        glViewport(0, 0, options.width, options.height);
        glDisable(GL_BLEND);
        glDisable(GL_CULL_FACE);
        glDepthMask(GL_TRUE);
        const bool seed = is_seed(look, options);
        const glm::vec4 behind = seed ? with(kSeedFog, 1.0) : glm::vec4(0.0f);
        glClearColor(behind.r, behind.g, behind.b, behind.a);
        glClear(GL_DEPTH_BUFFER_BIT | GL_COLOR_BUFFER_BIT);
        if (background && !seed) {
            glDisable(GL_DEPTH_TEST);
            sky.use();
            bind_frame(sky);
            bind_sky(sky);
            glBindVertexArray(no_vertices.name());
            glDrawArrays(GL_TRIANGLES, 0, 3);
            if (after_stage) after_stage("sky");
        }
        glEnable(GL_DEPTH_TEST);
        glDepthFunc(GL_LESS);
        glPolygonMode(GL_FRONT_AND_BACK, options.wireframe ? GL_LINE : GL_FILL);
        if (seed) {
            draw_seed(sea, camera);
        } else {
            if (options.shaded_samples > 1) glEnable(GL_SAMPLE_SHADING);
            glMinSampleShading(1.0f);
            draw_water(sea, camera, projection, parts_of(sea, camera, look, options));
            glDisable(GL_SAMPLE_SHADING);
        }
        if (after_stage) after_stage("water");
        glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
        for (GLint unit = 0; unit < units_used; ++unit) glBindSampler(static_cast<GLuint>(unit), 0);
        if (const GLenum error = glGetError(); error != GL_NO_ERROR) {
            throw Error(ErrorKind::no_gpu,
                        "OpenGL error " + std::to_string(error) + " while drawing the sea");
        }
    }

    void begin(gl::ShaderProgram& program, const ShownSea& sea, const WaterParts& parts,
               double farthest) {
        program.use();
        bind_frame(program);
        bind_maps(program, sea, parts);
        program.set("depth", farthest > 0.0
                                 ? static_cast<float>(1.0 / std::log2(1.0 + 2.0 * farthest))
                                 : 0.0f);
    }

    void draw_seed(const ShownSea& sea, const Camera& camera) {
        const WaterParts parts{sea.cascades.size(), sea.covers.size()};
        gl::ShaderProgram& seed = program(seeds, "seed", parts);
        const glm::dvec3 eye(camera.eye[0], camera.eye[1], camera.eye[2]);
        begin(seed, sea, parts, glm::length(eye) + kSeedTiles * sea.period);
        seed_mesh.draw(seed, eye, sea.period, finest_texel(sea));
    }

    void draw_water(const ShownSea& sea, const Camera& camera, const Projection& projection,
                    const WaterParts& parts) {
        const double crest = std::max(1.5 * sea.significant_wave_height, 0.1);
        const Reach reach{
            .sideways = 1.5 * sea.choppiness * sea.significant_wave_height,
            .up = crest,
            .farthest = 1.05 * (horizon_distance(camera.eye[2]) + horizon_distance(crest))};
        gl::ShaderProgram& water = program(waters, "water", parts);
        begin(water, sea, parts, projection.flat ? 0.0 : reach.farthest);
        clipmap.draw(water, {camera.eye[0], camera.eye[1], camera.eye[2]},
                     std::exp2(std::floor(std::log2(finest_texel(sea)))),
                     Frustum(projection.clip_from_world, camera.eye[2]), reach);
    }
};

Renderer::Renderer(const RendererOptions& options) : parts_(std::make_unique<Parts>(options)) {}
Renderer::~Renderer() = default;

std::size_t Renderer::most_cascades() const {
    // Three maps of each cascade, two covers and the sky.
    return std::min(kMostCascades,
                    static_cast<std::size_t>(std::max(parts_->texture_units - 3, 3)) / 3);
}

Pending Renderer::pending() const {
    return parts_->lace_used ? parts_->lace_maps.pending() : Pending::nothing;
}

void Renderer::draw(const ShownSea& sea, const Camera& camera, const Look& look,
                    const DrawOptions& options) {
    parts_->draw(sea, camera, look, options, perspective(camera, options.width, options.height),
                 row_of(options.view).use == ViewUse::picture);
}

void Renderer::draw_from_above(const ShownSea& sea, const Camera& camera, double x, double y,
                               double metres, const DrawOptions& options) {
    const double half = 0.5 * metres;
    const double east = x - camera.eye[0], north = y - camera.eye[1];
    const double drop = wave::double_precision::earth_drop(std::hypot(east, north));
    const double waves = 2.0 * sea.significant_wave_height + 1.0;
    const double still = -camera.eye[2];
    const glm::dmat4 lens = glm::ortho(east - half, east + half, north - half, north + half,
                                       -(still + waves), -(still - drop - waves));
    parts_->draw(sea, camera, Look{}, options, {glm::mat4(lens), 1.0, true}, false);
}

}  // namespace ocean::preview
