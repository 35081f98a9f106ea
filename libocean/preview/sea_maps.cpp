// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "ocean/preview/sea_maps.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "cover_power.hpp"
#include "detail_tiles.hpp"
#include "ocean/cascades.hpp"
#include "ocean/foam.hpp"
#include "ocean/gl/context.hpp"
#include "ocean/gl/shader_program.hpp"
#include "ocean/gl/textures.hpp"
#include "ocean/internal/open_sea.hpp"
#include "ocean/ocean.hpp"

namespace ocean::preview {
namespace {

using gl::Texture;

/// RGBA maps of all cascades, which the sea's own backend fills.
class UploadedCascades {
  public:
    UploadedCascades(int resolution, std::size_t cascades)
        : resolution_(resolution),
          cascades_(cascades),
          displacement_(array()),
          gradients_(array()),
          moments_(array()),
          displacement_image_(texels()),
          gradients_image_(texels()),
          moments_image_(texels()) {}

    bool fits(int resolution, std::size_t cascades) const {
        return resolution == resolution_ && cascades == cascades_;
    }

    void make(OpenSea& sea, double time) {
        for (std::size_t c = 0; c < cascades_; ++c) make_layer(sea, time, c);
        for (const Texture* texture : {&displacement_, &gradients_, &moments_}) {
            glBindTexture(GL_TEXTURE_2D_ARRAY, texture->name());
            glGenerateMipmap(GL_TEXTURE_2D_ARRAY);
        }
    }

    gl::CascadeArrays arrays() const {
        return {resolution_, displacement_.name(), gradients_.name(), moments_.name()};
    }

  private:
    void make_layer(OpenSea& sea, double time, std::size_t cascade) {
        using enum Linear;
        MapOutput outputs[2] = {{displacement_image_.data(), 4, {}},
                                {gradients_image_.data(), 4, {}}};
        outputs[0].component = {{{displacement_x}, {displacement_y}, {height}, {gradient_xy}}};
        outputs[1].component = {{{slope_x}, {slope_y}, {gradient_xx}, {gradient_yy}}};
        sea.evaluate_cascade_into(cascade, time, outputs, resolution_);
        for (std::size_t i = 0; i < gradients_image_.size(); i += 4) {
            const float* g = &gradients_image_[i];
            float* m = &moments_image_[i];
            m[0] = g[0] * g[0];
            m[1] = g[1] * g[1];
            m[2] = g[0] * g[1];
            m[3] = (g[2] + g[3]) * (g[2] + g[3]);
        }
        const auto layer = static_cast<GLint>(cascade);
        upload(displacement_, layer, displacement_image_);
        upload(gradients_, layer, gradients_image_);
        upload(moments_, layer, moments_image_);
    }

    std::size_t texels() const {
        return 4 * static_cast<std::size_t>(resolution_) * static_cast<std::size_t>(resolution_);
    }
    Texture array() const {
        return gl::make_texture_array(GL_RGBA32F, resolution_, static_cast<int>(cascades_),
                                      gl::Mipmaps::yes);
    }
    void upload(const Texture& texture, GLint layer, const std::vector<float>& image) const {
        glBindTexture(GL_TEXTURE_2D_ARRAY, texture.name());
        glTexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, 0, 0, layer, resolution_, resolution_, 1, GL_RGBA,
                        GL_FLOAT, image.data());
    }

    int resolution_;
    std::size_t cascades_;
    Texture displacement_, gradients_, moments_;
    std::vector<float> displacement_image_, gradients_image_, moments_image_;  // of one cascade
};

}  // namespace

class SeaMaps::Impl {
  public:
    Impl(const SeaMapsOptions& options, gl::AfterStage after_stage)
        : options_(options), after_stage_(std::move(after_stage)), coast_(options.coast) {
        if (options.compute) {
            computed_.emplace(
                gl::SeaTextureOptions{.cascade_resolution = options.cascade_resolution,
                                      .foam_resolution = options.foam_resolution,
                                      .foam_start = options.foam_start,
                                      .after_stage = after_stage_});
        }
        cover_program_ = gl::ShaderProgram(
            {{GL_VERTEX_SHADER, "preview/sky.vert"}, {GL_FRAGMENT_SHADER, "preview/cover.frag"}},
            "");
        no_vertices_ = gl::make_vertex_array();
        framebuffer_ = gl::make_framebuffer();
    }

    DrawnSea show(Ocean& of, double time, const std::optional<std::array<double, 3>>& eye) {
        OpenSea& sea = of.open_sea();
        if (computed_) {
            compute(sea, time);
        } else {
            upload(sea, time);
        }
        describe(sea, time);
        shown_.tiles.clear();
        if (options_.detail) {
            shown_.tiles = detail_.make(sea, time, shown_.cascades);
            done("detail");
        }
        shown_.coast = nullptr;
        if (const auto& bed = of.parameters().water.bed) {
            shown_.coast = eye ? coast_.show(of, time, *eye) : coast_.show_ground(bed);
            done("coast");
        }
        return shown_;
    }

    DrawnSea fade_from(const DrawnSea& before, double share) {
        if (shown_.coast && before.coast) shown_.coast = coast_.fade_from(*before.coast, share);
        return shown_;
    }

    void set_detail(bool on) { options_.detail = on; }
    // The sea itself follows the foam of its own backend, and knows its changes.
    void foam_changed(double from) {
        if (computed_) computed_->foam_changed(from);
    }
    void foam_changed() {
        if (computed_) computed_->foam_changed();
    }
    Pending pending() const { return cover_power_.pending(); }
    std::int64_t foam_settling_ticks(const Ocean& sea) const {
        return computed_ ? computed_->foam_settling_ticks() : sea.foam_settling_ticks();
    }

  private:
    void compute(OpenSea& sea, double time) {
        computed_->show(sea, time);
        show_cascades(sea.modes(time), computed_->arrays(), sea.parameters().grid.patch_size);
        const gl::FoamTexture& foam = computed_->foam();
        shown_.foam_threshold = static_cast<double>(foam.threshold);
        shown_.foam_width = static_cast<double>(foam.width);
        make_cover(foam.texture, foam.lattice.resolution, foam.fade,
                   power_of(sea, time, foam_of_lattice(foam.lattice)));
    }

    /// Returns the power of the foam that is its cover.
    double power_of(OpenSea& sea, double time, const ShownFoam& foam) {
        return options_.live ? cover_power_.of(sea, time, foam) : sea.cover_power(time, foam);
    }

    /// Makes the map of cover, foam^power, from a map of foam.
    void make_cover(GLuint foam, int resolution, float fade, double power) {
        if (!cover_ || resolution != cover_resolution_) {
            cover_ = gl::make_texture(GL_RGBA16F, resolution, gl::Mipmaps::yes);
            cover_resolution_ = resolution;
        }
        GLint viewport[4] = {};
        GLint framebuffer = 0;
        glGetIntegerv(GL_VIEWPORT, viewport);
        glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &framebuffer);
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer_.name());
        glFramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D,
                               cover_.name(), 0);
        glViewport(0, 0, resolution, resolution);
        glDisable(GL_DEPTH_TEST);
        glDisable(GL_BLEND);
        cover_program_.use();
        cover_program_.set("foam_map", 0);
        cover_program_.set("fade", fade);
        cover_program_.set("cover_power", static_cast<float>(power));
        glActiveTexture(GL_TEXTURE0);
        glBindSampler(0, 0);
        glBindTexture(GL_TEXTURE_2D, foam);
        glBindVertexArray(no_vertices_.name());
        glDrawArrays(GL_TRIANGLES, 0, 3);
        glBindVertexArray(0);
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(framebuffer));
        glViewport(viewport[0], viewport[1], viewport[2], viewport[3]);
        glBindTexture(GL_TEXTURE_2D, cover_.name());
        glGenerateMipmap(GL_TEXTURE_2D);
        done("cover");
    }

    void done(std::string_view stage) const {
        if (after_stage_) after_stage_(stage);
    }

    void upload(OpenSea& sea, double time) {
        glActiveTexture(GL_TEXTURE0);
        const Modes& modes = sea.modes(time);
        const Revision revision = modes.revision;
        const int foam_resolution = options_.foam_resolution > 0
                                        ? options_.foam_resolution
                                        : default_map_resolution(sea.parameters().grid);
        const SurfaceSettings settings = sea.sea().at(time).surface;
        if (!(revision == threshold_revision_) || !(settings == given_)) {
            const SurfaceSettings found = with_threshold(settings, modes, foam_resolution);
            shown_.foam_threshold = found.foam_threshold;
            shown_.foam_width = found.foam_width;
            threshold_revision_ = revision;
            given_ = settings;
        }
        // All cascades have the resolution of the sea's grid.
        const std::size_t count = modes.cascades.size();
        const int resolution = options_.cascade_resolution > 0
                                   ? options_.cascade_resolution
                                   : modes.cascades.front().lattice.resolution;
        if (!cascades_ || !cascades_->fits(resolution, count)) {
            cascades_.emplace(resolution, count);
        }
        cascades_->make(sea, time);
        show_cascades(sea.modes(time), cascades_->arrays(), sea.parameters().grid.patch_size);
        done("cascades");

        const FoamLattice lattice = foam_lattice(sea.parameters(), foam_resolution);
        foam_image_.resize(Lattice{lattice.resolution, 1.0}.size());
        sea.lattice_foam_into(time, lattice, foam_image_);
        if (!foam_ || lattice.resolution != uploaded_foam_resolution_) {
            foam_ = gl::make_texture(GL_R32F, lattice.resolution);
            uploaded_foam_resolution_ = lattice.resolution;
        }
        glBindTexture(GL_TEXTURE_2D, foam_.name());
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, lattice.resolution, lattice.resolution, GL_RED,
                        GL_FLOAT, foam_image_.data());
        done("foam");
        make_cover(foam_.name(), lattice.resolution, 1.0f,
                   power_of(sea, time, foam_of_lattice(lattice)));
    }

    void show_cascades(const Modes& modes, const gl::CascadeArrays& maps, double sea_period) {
        shown_.cascades.clear();
        for (const CascadeModes& cascade : modes.cascades) {
            const auto number = static_cast<int>(shown_.cascades.size());
            shown_.cascades.push_back(
                {maps, number, cascade.lattice.period, 1.0, sea_period, number});
        }
    }

    void describe(OpenSea& sea, double time) {
        shown_.time = time;
        shown_.period = sea.parameters().grid.patch_size;
        describe_pattern(sea.parameters(), sea.pool());
        shown_.covers = {{.texture = cover_.name(),
                          .resolution = cover_resolution_,
                          .period = shown_.period,
                          .direction = pattern_.direction,
                          .stretch = pattern_.stretch,
                          .streaks = pattern_.streaks}};
        // The threshold of water that is never squeezed is the lowest number; see
        // whitecap_threshold.
        shown_.has_foam = shown_.has_foam || shown_.foam_threshold > -1e30;
        shown_.choppiness = sea.sea().at(time).surface.choppiness;
        const Revision revision = sea.modes(time).revision;
        if (revision == described_) return;
        const Parameters& parameters = sea.parameters();
        const SurfaceSettings& surface = parameters.surface;
        const SpectralMoments moments = sea.spectrum(time).moments(
            parameters.water, surface.shortest_wavelength, surface.longest_wavelength);
        shown_.significant_wave_height = moments.significant_wave_height();
        shown_.peak_period = moments.peak_omega > 0.0 ? kTwoPi / moments.peak_omega : 0.0;
        shown_.mean_square_slope = moments.mean_square_slope;
        described_ = revision;
    }

    /// Sets the pattern of the foam: gales have streaks and long cells, as in POV-Ray's
    /// Ocean_Material.
    void describe_pattern(const Parameters& parameters, ThreadPool& pool) {
        if (patterned_ && same_waves(parameters, *patterned_)) return;
        const SpectralMoments moments =
            make_directional_spectrum(parameters, pool).moments(parameters.water);
        const double height = moments.significant_wave_height();
        pattern_.direction = moments.mean_direction;
        pattern_.stretch = 1.5 + 0.7 * std::clamp((height - 4.0) / 3.0, 0.0, 1.0);
        pattern_.streaks = 0.3 * std::clamp((height - 2.0) / 4.0, 0.0, 1.0);
        patterned_ = parameters;
    }

    static bool same_waves(const Parameters& a, const Parameters& b) {
        const auto first = first_dirty_stage(a, b);
        return !first || *first > Stage::spectrum;
    }

    SeaMapsOptions options_;
    gl::AfterStage after_stage_;
    DrawnSea shown_;
    DrawnCover pattern_;
    std::optional<Parameters> patterned_;  // the parameters of pattern_
    Revision described_;                   // revision of the described modes
    CoverPower cover_power_;               // for live maps
    DetailTiles detail_;
    Texture cover_;
    int cover_resolution_ = 0;
    gl::ShaderProgram cover_program_;
    gl::VertexArray no_vertices_;
    gl::Framebuffer framebuffer_;

    CoastMaps coast_;  // of a sea over a bed, beside its maps

    // Computed by shaders.
    std::optional<gl::SeaTextures> computed_;

    // Computed by the sea.
    std::optional<UploadedCascades> cascades_;
    std::vector<float> foam_image_;
    Texture foam_;
    int uploaded_foam_resolution_ = 0;
    Revision threshold_revision_;
    SurfaceSettings given_;
};

double finest_texel(const DrawnSea& sea) {
    double finest = sea.period;
    if (sea.coast && !sea.coast->windows.empty()) finest = sea.coast->windows[0].window.cell;
    for (const DrawnCascade& cascade : sea.cascades) {
        finest = std::min(finest, cascade.period / cascade.maps.resolution);
    }
    return finest;
}

DrawnSea cross_fade(const DrawnSea& from, const DrawnSea& to, double share, double correlation) {
    const double angle = 0.25 * kTwoPi * std::clamp(share, 0.0, 1.0);
    const double a = std::cos(angle), b = std::sin(angle);
    const auto mean_square = [&](double x, double y) {
        return std::sqrt(a * a * x * x + b * b * y * y);
    };
    // Waves that both have add up by their heights, not by their energies.
    const double height = mean_square(from.significant_wave_height, to.significant_wave_height);
    const double shared = 2.0 * a * b * std::max(correlation, -0.9) * from.significant_wave_height *
                          to.significant_wave_height;
    const double sum = std::sqrt(height * height + shared);
    const double scale = sum > 0.0 ? height / sum : 1.0;
    DrawnSea both = to;
    for (DrawnCascade& cascade : both.cascades) cascade.weight *= b * scale;
    for (DrawnTile& tile : both.tiles) tile.weight *= b * scale;
    for (DrawnCover& cover : both.covers) cover.share *= b * b;
    for (DrawnCascade cascade : from.cascades) {
        cascade.weight *= a * scale;
        both.cascades.push_back(cascade);
    }
    for (DrawnTile tile : from.tiles) {
        tile.weight *= a * scale;
        both.tiles.push_back(tile);
    }
    for (DrawnCover cover : from.covers) {
        cover.share *= a * a;
        both.covers.push_back(cover);
    }
    both.has_foam = from.has_foam || to.has_foam;
    both.choppiness = mean_square(from.choppiness, to.choppiness);
    both.significant_wave_height = height;
    both.mean_square_slope = a * a * from.mean_square_slope + b * b * to.mean_square_slope;
    return both;
}

SeaMaps::SeaMaps(const SeaMapsOptions& options, gl::AfterStage after_stage)
    : impl_(std::make_unique<Impl>(options, std::move(after_stage))) {}
SeaMaps::~SeaMaps() = default;

DrawnSea SeaMaps::show(Ocean& sea, double time, const std::optional<std::array<double, 3>>& eye) {
    return impl_->show(sea, time, eye);
}

DrawnSea SeaMaps::fade_from(const DrawnSea& before, double share) {
    return impl_->fade_from(before, share);
}

void SeaMaps::set_detail(bool on) {
    impl_->set_detail(on);
}

void SeaMaps::foam_changed(double from) {
    impl_->foam_changed(from);
}

void SeaMaps::foam_changed() {
    impl_->foam_changed();
}

Pending SeaMaps::pending() const {
    return impl_->pending();
}

std::int64_t SeaMaps::foam_settling_ticks(const Ocean& sea) const {
    return impl_->foam_settling_ticks(sea);
}

}  // namespace ocean::preview
