// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A sea as textures; see ocean/gl/sea_textures.hpp.
#include "ocean/gl/sea_textures.hpp"

#include <optional>
#include <vector>

#include "checks.hpp"
#include "map_frame.hpp"
#include "ocean/foam_follower.hpp"
#include "ocean/gl/context.hpp"
#include "ocean/ocean.hpp"

namespace ocean::gl {

namespace {

const std::vector<Quantity>& cascade_quantities() {
    using enum Linear;
    static const std::vector<Quantity> quantities = {displacement_x, displacement_y, height,
                                                     gradient_xy,    slope_x,        slope_y,
                                                     gradient_xx,    gradient_yy};
    return quantities;
}

/// The textures of one cascade.
class CascadeFrame {
  public:
    CascadeFrame(int resolution, const ContextInfo& limits)
        : resolution_(resolution),
          frame_(resolution, limits, Mipmaps::yes),
          moments_(make_texture(GL_RGBA32F, resolution, Mipmaps::yes)) {}

    CascadeTextures make(const MapRequest& request, ComputeProgram& moments, ThreadPool& pool) {
        frame_.make(request, cascade_quantities(), nullptr, pool);
        moments.use();
        glBindImageTexture(0, frame_.map(1).name(), 0, GL_FALSE, 0, GL_READ_ONLY, GL_RGBA32F);
        glBindImageTexture(1, moments_.name(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA32F);
        dispatch_texels(resolution_);
        glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT |
                        GL_FRAMEBUFFER_BARRIER_BIT);
        for (const GLuint texture : {frame_.map(0).name(), frame_.map(1).name(), moments_.name()}) {
            glBindTexture(GL_TEXTURE_2D, texture);
            glGenerateMipmap(GL_TEXTURE_2D);
        }
        require_no_error("making the textures of a cascade");
        return {request.modes.period, resolution_, frame_.map(0).name(), frame_.map(1).name(),
                moments_.name()};
    }

    int resolution() const { return resolution_; }

  private:
    int resolution_;
    MapFrame frame_;
    Texture moments_;
};

}  // namespace

struct SeaTextures::Impl {
    using Follower = FoamFollower<Texture>;

    SeaTextureOptions options;
    ContextInfo limits = context_info();
    ThreadPool pool{0};
    ComputeProgram moments{"compute/moments.comp", ""};
    std::vector<CascadeFrame> frames;
    std::vector<CascadeTextures> cascades;

    int foam_resolution = 0;
    std::optional<MapFrame> foam_frame;
    std::optional<Follower> follower;
    FoamClock clock;
    FoamTexture foam;
    SurfaceSettings given;
    SurfaceSettings shown;
    Revision shown_revision;
    int shown_for = 0;

    void make_cascades(Ocean& sea, double time) {
        const Modes& modes = sea.modes(time);
        while (frames.size() > modes.cascades.size()) frames.pop_back();
        cascades.resize(modes.cascades.size());
        for (std::size_t c = 0; c < modes.cascades.size(); ++c) {
            const int resolution = options.cascade_resolution > 0
                                       ? options.cascade_resolution
                                       : modes.cascades[c].lattice.resolution;
            if (c == frames.size()) frames.emplace_back(resolution, limits);
            if (frames[c].resolution() != resolution) frames[c] = CascadeFrame(resolution, limits);
            const MapRequest request{cascade_modes(modes, c, time, resolution), {}, {}, {}};
            cascades[c] = frames[c].make(request, moments, pool);
        }
    }

    /// Returns the settings with the whitecaps' threshold, which is computed again when something
    /// has changed.
    SurfaceSettings shown_settings(const Ocean& sea, const Modes& modes, double time) {
        const SurfaceSettings settings = sea.sea().at(time).surface;
        if (modes.revision != shown_revision || settings != given || foam_resolution != shown_for) {
            shown = with_threshold(settings, modes, foam_resolution);
            given = settings;
            shown_revision = modes.revision;
            shown_for = foam_resolution;
        }
        return shown;
    }

    /// Makes the foam of a tick from that of the tick before.
    void make_tick(Ocean& sea, double time, const Follower::Layer& before, Texture& tick) {
        const Modes& modes = sea.modes(time);
        if (!tick) tick = make_texture(GL_R32F, foam_resolution, Mipmaps::no, Filter::linear);
        MapRequest request{
            map_modes(modes, time, foam_resolution), shown_settings(sea, modes, time), {}, {}};
        request.foam = {nullptr, before.fade, before.cutoff};
        foam_frame->exchange_map(0, GL_R32F, tick);
        foam_frame->make(request, {Channel::foam}, before.map, pool);
        foam_frame->exchange_map(0, GL_R32F, tick);
    }

    void make_foam(Ocean& sea, double time) {
        const Parameters& parameters = sea.parameters();
        const int resolution = options.foam_resolution > 0
                                   ? options.foam_resolution
                                   : default_map_resolution(parameters.grid);
        const FoamClock now = foam_clock(parameters.surface, parameters.time.loop_period);
        if (!follower || !(now == clock) || resolution != foam_resolution) {
            follower.emplace(now, options.foam_start);
            clock = now;
        }
        if (!foam_frame || resolution != foam_resolution) foam_frame.emplace(resolution, limits);
        foam_resolution = resolution;
        const Follower::Source source{[&](double t) { return sea.sea().foam_lifetime(t); },
                                      [&](double t, const Follower::Layer& before, Texture& tick) {
                                          make_tick(sea, t, before, tick);
                                      },
                                      options.foam_progress};
        const Follower::Layer layer = follower->layer(time, source);
        const Modes& modes = sea.modes(time);
        const SurfaceSettings settings = shown_settings(sea, modes, time);
        foam = {layer.map->name(),
                resolution,
                parameters.grid.patch_size,
                layer.fade,
                static_cast<float>(settings.foam_threshold),
                static_cast<float>(settings.foam_width)};
    }
};

SeaTextures::SeaTextures(SeaTextureOptions options) : impl_(std::make_unique<Impl>()) {
    impl_->options = std::move(options);
}

SeaTextures::~SeaTextures() = default;

void SeaTextures::show(Ocean& sea, double time) {
    require_time(time);
    const auto done = [&](std::string_view stage) {
        if (impl_->options.after_stage) impl_->options.after_stage(stage);
    };
    impl_->make_foam(sea, time);
    done("foam");
    impl_->make_cascades(sea, time);
    done("cascades");
    require_not_reset(impl_->limits, "making the sea's textures");
}

void SeaTextures::foam_changed(double from) {
    if (impl_->follower) impl_->follower->forget_from(from);
}

void SeaTextures::foam_changed() {
    impl_->follower.reset();
}

std::span<const CascadeTextures> SeaTextures::cascades() const {
    return impl_->cascades;
}

const FoamTexture& SeaTextures::foam() const {
    return impl_->foam;
}

std::int64_t SeaTextures::foam_settling_ticks() const {
    return impl_->follower ? impl_->follower->settling_ticks() : 0;
}

}  // namespace ocean::gl
