// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A sea as textures; see ocean/internal/gl/sea_textures.hpp.
#include "ocean/internal/gl/sea_textures.hpp"

#include <optional>
#include <vector>

#include "checks.hpp"
#include "map_frame.hpp"
#include "ocean/internal/foam_follower.hpp"
#include "ocean/internal/gl/context.hpp"
#include "ocean/internal/map_request.hpp"
#include "ocean/internal/open_sea.hpp"

namespace ocean::gl {

namespace {

const std::vector<Quantity>& cascade_quantities() {
    using enum Linear;
    static const std::vector<Quantity> quantities = {displacement_x, displacement_y, height,
                                                     gradient_xy,    slope_x,        slope_y,
                                                     gradient_xx,    gradient_yy};
    return quantities;
}

constexpr GLenum kFormat = GL_RGBA32F;

/// The arrays whose layers are the maps of the cascades.
struct Arrays {
    Arrays(int resolution, std::size_t cascades)
        : resolution(resolution),
          layers(static_cast<int>(cascades)),
          displacement(make_texture_array(kFormat, resolution, layers, Mipmaps::yes)),
          gradients(make_texture_array(kFormat, resolution, layers, Mipmaps::yes)),
          moments(make_texture_array(kFormat, resolution, layers, Mipmaps::yes)) {}

    bool fits(int n, std::size_t cascades) const {
        return n == resolution && static_cast<int>(cascades) == layers;
    }
    void make_mipmaps() const {
        for (const Texture* array : {&displacement, &gradients, &moments}) {
            glBindTexture(GL_TEXTURE_2D_ARRAY, array->name());
            glGenerateMipmap(GL_TEXTURE_2D_ARRAY);
        }
    }

    int resolution;
    int layers;
    Texture displacement, gradients, moments;
};

/// Computes one cascade into its layer of the arrays.
class CascadeFrame {
  public:
    CascadeFrame(const Arrays& arrays, int layer, const ContextInfo& limits)
        : resolution_(arrays.resolution),
          frame_(arrays.resolution, limits, Mipmaps::yes),
          moments_(view(arrays.moments, layer)) {
        Texture displacement = view(arrays.displacement, layer);
        Texture gradients = view(arrays.gradients, layer);
        frame_.exchange_map(0, kFormat, displacement);
        frame_.exchange_map(1, kFormat, gradients);
    }

    CascadeTextures make(const MapRequest& request, ComputeProgram& moments, ThreadPool& pool) {
        frame_.make(request, cascade_quantities(), nullptr, pool);
        moments.use();
        glBindImageTexture(0, frame_.map(1).name(), 0, GL_FALSE, 0, GL_READ_ONLY, GL_RGBA32F);
        glBindImageTexture(1, moments_.name(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA32F);
        dispatch_texels(resolution_);
        glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT |
                        GL_FRAMEBUFFER_BARRIER_BIT);
        require_no_error("making the textures of a cascade");
        return {request.modes.period, resolution_, frame_.map(0).name(), frame_.map(1).name(),
                moments_.name()};
    }

  private:
    Texture view(const Texture& array, int layer) const {
        return make_layer_view(array, kFormat, resolution_, layer, Mipmaps::yes);
    }

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
    std::optional<Arrays> arrays;
    std::vector<CascadeFrame> frames;  // a layer of the arrays each
    std::vector<CascadeTextures> cascades;

    int foam_map = 0;  // the resolution of the map whose foam is followed
    FoamLattice lattice{};
    std::optional<MapFrame> foam_frame;
    std::optional<Follower> follower;
    FoamClock clock;
    Texture foam_now;  // of a lattice whose whitecaps are not the map's, at the time shown
    FoamTexture foam;
    SurfaceSettings given;
    SurfaceSettings shown;  // with the threshold of the map's whitecaps
    SurfaceSettings past;   // with that of the lattice's
    Revision shown_revision;
    int shown_for = 0;

    void make_cascades(OpenSea& sea, double time) {
        const Modes& modes = sea.modes(time);
        const std::size_t count = modes.cascades.size();
        // All cascades have the resolution of the sea's grid.
        const int resolution = options.cascade_resolution > 0
                                   ? options.cascade_resolution
                                   : modes.cascades.front().lattice.resolution;
        if (!arrays || frames.size() != count || !arrays->fits(resolution, count)) {
            require_limits(resolution, limits);
            frames.clear();
            arrays.emplace(resolution, count);
            for (std::size_t c = 0; c < count; ++c) {
                frames.emplace_back(*arrays, static_cast<int>(c), limits);
            }
        }
        cascades.resize(count);
        for (std::size_t c = 0; c < count; ++c) {
            const MapRequest request{cascade_modes(modes, c, time, resolution), {}, {}, {}};
            cascades[c] = frames[c].make(request, moments, pool);
        }
        arrays->make_mipmaps();
        require_no_error("making the mipmaps of the cascades");
    }

    /// Returns the settings with the whitecaps' threshold, which is computed again when something
    /// has changed.
    SurfaceSettings shown_settings(const OpenSea& sea, const Modes& modes, double time) {
        const Parameters now = sea.sea().at(time);
        const SurfaceSettings& settings = now.surface;
        if (modes.revision != shown_revision || settings != given || foam_map != shown_for) {
            shown = with_threshold(settings, modes, foam_map);
            past = lattice.is_spread() ? lattice_settings(modes, now, lattice) : shown;
            given = settings;
            shown_revision = modes.revision;
            shown_for = foam_map;
        }
        return shown;
    }

    /// Makes the foam of a tick from that of the tick before.
    void make_tick(OpenSea& sea, double time, const Follower::Layer& before, Texture& tick) {
        const Modes& modes = sea.modes(time);
        if (!tick) tick = make_texture(GL_R32F, lattice.resolution, Mipmaps::no, Filter::linear);
        shown_settings(sea, modes, time);
        MapRequest request{map_modes(modes, time, lattice.resolution), past, {}, {}};
        request.modes.held_by = lattice.held_by;
        request.foam = {nullptr, before.fade, before.cutoff};
        foam_frame->exchange_map(0, GL_R32F, tick);
        foam_frame->make(request, {Channel::foam}, before.map, pool);
        foam_frame->exchange_map(0, GL_R32F, tick);
    }

    void make_foam(OpenSea& sea, double time) {
        const Parameters& parameters = sea.parameters();
        foam_map = options.foam_resolution > 0 ? options.foam_resolution
                                               : default_map_resolution(parameters.grid);
        const FoamLattice now_on = foam_lattice(parameters, foam_map);
        const FoamClock now = foam_clock(parameters.surface, parameters.time.loop_period);
        if (!follower || !(now == clock) || now_on != lattice) {
            follower.emplace(now, options.foam_start);
            clock = now;
        }
        if (!foam_frame || now_on != lattice) {
            foam_frame.emplace(now_on.resolution, limits);
            foam_now = {};
        }
        lattice = now_on;
        const Follower::Source source{[&](double t) { return sea.sea().foam_lifetime(t); },
                                      [&](double t, const Follower::Layer& before, Texture& tick) {
                                          make_tick(sea, t, before, tick);
                                      },
                                      options.foam_progress};
        const Follower::Layer layer = follower->layer(time, source);
        const Modes& modes = sea.modes(time);
        const SurfaceSettings settings = shown_settings(sea, modes, time);
        const bool is_spread = lattice.is_spread();
        if (is_spread) make_tick(sea, time, layer, foam_now);
        foam = {.texture = is_spread ? foam_now.name() : layer.map->name(),
                .map_resolution = foam_map,
                .lattice = lattice,
                .period = parameters.grid.patch_size,
                .fade = is_spread ? 1.0f : layer.fade,
                .alone = is_spread ? 0.0f : 1.0f,
                .threshold = static_cast<float>(settings.foam_threshold),
                .width = static_cast<float>(settings.foam_width)};
    }
};

SeaTextures::SeaTextures(SeaTextureOptions options) : impl_(std::make_unique<Impl>()) {
    impl_->options = std::move(options);
}

SeaTextures::~SeaTextures() = default;

void SeaTextures::show(OpenSea& sea, double time) {
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

CascadeArrays SeaTextures::arrays() const {
    if (!impl_->arrays) return {};
    const Arrays& arrays = *impl_->arrays;
    return {arrays.resolution, arrays.displacement.name(), arrays.gradients.name(),
            arrays.moments.name()};
}

const FoamTexture& SeaTextures::foam() const {
    return impl_->foam;
}

std::int64_t SeaTextures::foam_settling_ticks() const {
    return impl_->follower ? impl_->follower->settling_ticks() : 0;
}

}  // namespace ocean::gl
