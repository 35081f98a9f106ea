// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The facade of a terrain; see terrain.hpp.
#include "ocean/terrain.hpp"
#include "ocean/internal/make_surface.hpp"
#include "ocean/internal/map_request.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>

#include "land/function/build_function.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/memory.hpp"
#include "ocean/internal/sea_bytes.hpp"
#include "ocean/internal/surface_query.hpp"
#include "ocean/land_function.hpp"
#include "ocean/land_mask.hpp"
#include "ocean/terrain_table.hpp"
#include "waves/surface/map_writer.hpp"

namespace ocean {
namespace {

/// The settings of a surface without displacement.
SurfaceSettings flat_settings() {
    SurfaceSettings settings;
    settings.choppiness = 0.0;
    return settings;
}

/// Throws for channels that the land does not have.
void require_terrain_channels(ChannelSet wanted, ChannelSet available) {
    for (int c = 0; c <= kChannelNumbers; ++c) {
        const auto channel = static_cast<Channel>(c);
        if (!wanted.contains(channel) || available.contains(channel)) continue;
        const std::string name(channel_info(channel).name);
        if (is_mask(channel)) {
            throw Error(ErrorKind::unsupported, "this terrain has no mask " + name +
                                                    ": its file has no section that makes it");
        }
        throw Error(ErrorKind::unsupported,
                    "a terrain has no channel " + name + "; it has height, normals and slopes");
    }
}

/// Adds the height to one component of an output, also on its seam.
void add_to(const MapOutput& output, std::size_t component, float height, int resolution,
            ThreadPool& pool) {
    const int rows = resolution + (output.seam ? 1 : 0);
    const auto step = static_cast<std::size_t>(output.components);
    const std::size_t width = output.width(resolution);
    pool.for_each_range(rows, [&](int first, int last) {
        for (int j = first; j < last; ++j) {
            float* const row =
                output.data + static_cast<std::size_t>(j) * output.pitch(resolution) + component;
            for (std::size_t i = 0; i < width; i += step) row[i] += height;
        }
    });
}

}  // namespace

struct Terrain::Impl {
    Impl(TerrainModel its_model, const TerrainOptions& options)
        : model(std::move(its_model)),
          pool(options.threads, options.run_jobs),
          writer(options.backend) {
        pool.set_interrupt(options.interrupt);
        progress = options.progress;
    }
    Impl(const Impl& other, const TerrainOptions& options)
        : model(other.model),
          pool(options.threads, options.run_jobs),
          writer(other.writer, {}),
          noise(other.noise),
          modes(other.modes),
          is_filtered(other.is_filtered),
          scale(other.scale),
          offset(other.offset),
          function(other.function),
          carved(other.carved) {
        pool.set_interrupt(options.interrupt);
        progress = options.progress;
        if (!(options.backend == other.writer.backend())) writer = MapWriter(options.backend);
    }

    /// Discards the results that a change from the present terrain makes stale.
    void go_to(TerrainModel next) {
        const auto dirty = first_dirty_stage(model, next);
        model = std::move(next);
        if (!dirty) return;
        if (*dirty == TerrainStage::noise) noise = nullptr;
        function = nullptr;
        if (*dirty <= TerrainStage::filter) {
            is_filtered = false;
            query.reset();
        } else if (model.range.empty()) {
            offset = model.mean;  // with a range, the offset fits it
        }
    }

    void make_noise() {
        if (noise != nullptr) return;
        if (model.base_model != nullptr) {
            throw Error(ErrorKind::unsupported,
                        "the land of an elevation model has no waves of a law: terrain.base");
        }
        require_memory(Terrain::bytes(model), "the terrain");
        noise = std::make_shared<const TerrainNoise>(model, pool);
        ++runs.noise;
    }

    void filter() {
        if (is_filtered) return;
        make_noise();
        // Modes that another Terrain shares must not change.
        const Lattice lattice = lattice_of(model);
        const bool reusable = modes != nullptr && modes.use_count() == 1 &&
                              modes->lattice.resolution == lattice.resolution &&
                              modes->lattice.period == lattice.period;
        if (!reusable) modes = std::make_shared<Modes>(empty_terrain_modes(model));
        ++runs.filter;
        offset = model.mean;
        scale = set_terrain_modes(model, *noise, asked_rms(), pool, *modes);
        if (!model.range.empty()) fit_range();
        is_filtered = true;
    }

    /// Scales the modes so that the samples of the terrain's own map reach from one end of the
    /// range to the other.
    void fit_range() {
        const Surface map = make_surface(*modes, flat_settings(), 0.0, {Channel::height},
                                         Backend::cpu, pool, model.resolution);
        const auto [low, high] = std::ranges::minmax(map.channel(Channel::height));
        const double spread = static_cast<double>(high) - static_cast<double>(low);
        const double gain = spread > 0.0 ? (model.range[1] - model.range[0]) / spread : 0.0;
        offset = model.range[0] - gain * static_cast<double>(low);
        scale = set_terrain_modes(model, *noise, gain * scale.rms, pool, *modes);
    }

    std::optional<double> asked_rms() const {
        if (model.rms || model.has_measured_rms()) return model.rms;
        return kDefaultTerrainRms;
    }

    const LandFunction& shape() {
        if (function != nullptr) return *function;
        require_memory(function_bytes(model), "the terrain");
        if (model.base_model == nullptr) filter();
        if (model.is_shaped()) {
            LandWaves waves;
            if (model.base_model == nullptr) waves = {noise.get(), asked_rms(), scale.gain};
            const auto before = carved.land;
            function = std::make_shared<const LandFunction>(
                build_function(model, waves, pool, carved, progress));
            if (carved.land != before) ++runs.streams;
        } else {
            function = std::make_shared<const LandFunction>(
                build_tile_function(model, *modes, offset, pool));
        }
        ++runs.shape;
        return *function;
    }

    /// Returns the query with these options; keeps it for the next call.
    const SurfaceQuery& surface_query(QueryOptions options) {
        filter();
        options.foam = false;
        if (query && query->options == options) return query->query;
        require_memory(SurfaceQuery::bytes(*modes, options), "the query",
                       "choose a smaller resolution or refine less");
        query.reset();
        query.emplace(CachedQuery{
            options, SurfaceQuery(*modes, flat_settings(), Water{}, 0.0, options, pool)});
        return query->query;
    }

    TerrainModel model;
    ThreadPool pool;
    MapWriter writer;
    std::shared_ptr<const TerrainNoise> noise;
    std::shared_ptr<Modes> modes;
    bool is_filtered = false;
    TerrainScale scale;
    double offset = 0.0;
    TerrainRuns runs;
    std::shared_ptr<const LandFunction> function;
    CarvedLand carved;
    LandProgress progress;

    struct CachedQuery {
        QueryOptions options;
        SurfaceQuery query;
    };
    std::optional<CachedQuery> query;
};

Terrain::Terrain(TerrainModel model, const TerrainOptions& options) {
    validate(model);
    impl_ = std::make_unique<Impl>(std::move(model), options);
}

Terrain::Terrain(const Terrain& shared, const TerrainOptions& options)
    : impl_(std::make_unique<Impl>(*shared.impl_, options)) {}

Terrain::~Terrain() = default;

const TerrainModel& Terrain::model() const {
    return impl_->model;
}

void Terrain::set_model(TerrainModel model) {
    validate(model);
    impl_->go_to(std::move(model));
}

void Terrain::set(std::string_view name, std::string_view value) {
    TerrainModel next = impl_->model;
    set_parameter(next, name, value);
    set_model(std::move(next));
}

const Modes& Terrain::modes() {
    impl_->filter();
    return *impl_->modes;
}

double Terrain::offset() {
    impl_->filter();
    return impl_->offset;
}

TerrainScale Terrain::scale() {
    impl_->filter();
    return impl_->scale;
}

TerrainState Terrain::state() {
    TerrainState state;
    if (impl_->model.base_model == nullptr) {
        impl_->filter();
        state = terrain_state(impl_->model, *impl_->modes, impl_->scale, impl_->offset);
    } else {
        constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
        state.rms.asked = state.rms_slope.asked = kUnknown;
        const Domain land = domain();
        state.longest_wave = std::max(land.size[0], land.size[1]);
        state.memory_bytes = bytes(impl_->model);
    }
    if (!impl_->model.is_shaped()) return state;
    constexpr int kMaxMeasured = 1024;  // samples; up to here as fine as the land's own grid
    const Domain own = domain();
    const int longer = std::max(own.samples[0], own.samples[1]);
    const Domain measured = longer > kMaxMeasured ? domain(kMaxMeasured) : own;
    measure_shaped(region(measured, {Channel::height, Channel::slope_x, Channel::slope_y}), state);
    state.cell = own.step(0);
    state.shortest_wave = 2.0 * state.cell;
    return state;
}

std::shared_ptr<const LandFunction> Terrain::function() {
    impl_->shape();
    return impl_->function;
}

ChannelSet Terrain::channels() const {
    return terrain_channels(impl_->model);
}

Domain Terrain::domain(int resolution) const {
    return terrain_domain(impl_->model, resolution);
}

Surface Terrain::surface(ChannelSet channels, int resolution) {
    require_terrain_channels(channels, this->channels());
    const Domain domain = this->domain(resolution);
    if (impl_->model.is_shaped()) return region(domain, channels);
    require_resolution(domain.samples[0]);
    Surface surface(domain, 0.0, channels);
    surface_into(outputs_of(surface), domain.samples[0]);
    return surface;
}

Surface Terrain::region(const Domain& region, ChannelSet channels) {
    require_terrain_channels(channels, this->channels());
    const LandFunction& function = impl_->shape();
    ++impl_->runs.maps;
    return function.surface(region, channels, impl_->pool);
}

void Terrain::region_into(const Domain& region, std::span<const MapOutput> outputs) {
    require_terrain_channels(channels_of(outputs), channels());
    const LandFunction& function = impl_->shape();
    ++impl_->runs.maps;
    function.write(region, outputs, impl_->pool);
}

void Terrain::surface_into(std::span<const MapOutput> outputs, int resolution) {
    require_terrain_channels(channels_of(outputs), channels());
    if (impl_->model.is_shaped()) return shaped_into(outputs, resolution);
    if (resolution == 0) resolution = impl_->model.resolution;
    require_resolution(resolution);
    const Modes& modes = this->modes();
    impl_->writer.write({map_modes(modes, 0.0, resolution), flat_settings(), outputs, {}},
                        impl_->pool);
    ++impl_->runs.maps;
    if (impl_->offset == 0.0) return;
    for (const MapOutput& output : outputs) {
        for (std::size_t c = 0; c < output.used().size(); ++c) {
            const auto& [quantity, factor] = output.component[c];
            if (quantity == Quantity(Channel::height) || quantity == Quantity(Linear::height)) {
                add_to(output, c, factor * static_cast<float>(impl_->offset), resolution,
                       impl_->pool);
            }
        }
    }
}

void Terrain::shaped_into(std::span<const MapOutput> outputs, int resolution) {
    const Domain domain = this->domain(resolution);
    if (domain.samples[0] != domain.samples[1]) {
        throw Error(ErrorKind::unsupported, "this land is not a square: its maps have " +
                                                std::to_string(domain.samples[0]) + " x " +
                                                std::to_string(domain.samples[1]) +
                                                " samples; ask for a region");
    }
    for (const MapOutput& output : outputs) {
        if (!output.seam || domain.wraps) continue;
        throw Error(ErrorKind::unsupported, "a land that exists once has no seam");
    }
    const LandFunction& function = impl_->shape();
    ++impl_->runs.maps;
    function.write(domain, outputs, impl_->pool);
}

void Terrain::query(std::span<const WorldPoint> points, std::span<QuerySample> samples,
                    const QueryOptions& options) {
    if (impl_->model.is_shaped()) {
        const LandFunction& function = impl_->shape();
        const double cell =
            options.resolution > 0 ? domain(options.resolution).step(0) : domain().step(0);
        return function.query(points, samples, cell, impl_->pool);
    }
    impl_->surface_query(options).sample(points, samples, impl_->pool);
    for (QuerySample& sample : samples.first(points.size())) sample.height += impl_->offset;
}

double Terrain::query_height_error(const QueryOptions& options) {
    if (impl_->model.is_shaped()) return 0.0;  // the function itself is the land
    return impl_->surface_query(options).height_error();
}

const TerrainRuns& Terrain::runs() const {
    return impl_->runs;
}

ThreadPool& Terrain::pool() {
    return impl_->pool;
}

ChannelSet terrain_channels(const TerrainModel& model) {
    ChannelSet channels = kTerrainChannels;
    const auto add = [&](std::initializer_list<LandMask> masks) {
        for (const LandMask mask : masks) channels = channels | channel_of(mask);
    };
    using enum LandMask;
    if (model.has_gullies()) add({wear, gully, ridge});
    if (model.has_streams()) add({flow, deposit, streambed, wetness});
    if (model.has_coast()) add({beach, cliff, shelter});
    return channels;
}

Domain terrain_domain(const TerrainModel& model, int resolution) {
    if (!model.is_placed()) {
        return Domain::tile(model.patch_size, resolution == 0 ? model.resolution : resolution);
    }
    const Domain own = placed_domain(model);
    if (resolution == 0) return own;
    return with_cell(own, std::max(own.size[0], own.size[1]) / (resolution - 1));
}

std::uint64_t Terrain::bytes(const TerrainModel& model) {
    if (model.is_shaped()) return function_bytes(model);
    Grid grid;
    grid.resolution = model.resolution;
    return modes_bytes(grid) + lattice_of(model).size() / 2 * sizeof(std::complex<float>);
}

}  // namespace ocean
