// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The facade of a terrain; see land.hpp.
#include "ocean/land.hpp"
#include "ocean/make_surface.hpp"
#include "ocean/map_request.hpp"
#include "ocean/region.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "land/function/build_field.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/memory.hpp"
#include "ocean/internal/sea_bytes.hpp"
#include "ocean/land_field.hpp"
#include "ocean/land_mask.hpp"
#include "ocean/surface_query.hpp"
#include "ocean/terrain_table.hpp"
#include "ocean/thread_pool.hpp"
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

struct Land::Impl {
    Impl(TerrainModel its_terrain, const LandOptions& options)
        : terrain(std::move(its_terrain)),
          pool(options.threads, options.run_jobs),
          writer(options.backend) {
        pool.set_interrupt(options.interrupt);
        progress = options.progress;
    }
    Impl(const Impl& other, const LandOptions& options)
        : terrain(other.terrain),
          pool(options.threads, options.run_jobs),
          writer(other.writer, {}),
          noise(other.noise),
          modes(other.modes),
          is_filtered(other.is_filtered),
          scale(other.scale),
          offset(other.offset),
          field(other.field),
          carved(other.carved) {
        pool.set_interrupt(options.interrupt);
        progress = options.progress;
        if (!(options.backend == other.writer.backend())) writer = MapWriter(options.backend);
    }

    /// Forgets what a change from the present terrain makes stale.
    void go_to(TerrainModel next) {
        const auto dirty = first_dirty_stage(terrain, next);
        terrain = std::move(next);
        if (!dirty) return;
        if (*dirty == TerrainStage::noise) noise = nullptr;
        field = nullptr;
        if (*dirty <= TerrainStage::filter) {
            is_filtered = false;
            query.reset();
        } else if (terrain.range.empty()) {
            offset = terrain.mean;  // else the offset fits the range
        }
    }

    void make_noise() {
        if (noise != nullptr) return;
        if (terrain.base_model != nullptr) {
            throw Error(ErrorKind::unsupported,
                        "the land of an elevation model has no waves of a law: terrain.base");
        }
        require_memory(Land::bytes(terrain), "the terrain");
        noise = std::make_shared<const TerrainNoise>(terrain, pool);
        ++runs.noise;
    }

    void filter() {
        if (is_filtered) return;
        make_noise();
        // Modes that another Land shows stay as they are.
        const Lattice lattice = lattice_of(terrain);
        const bool reusable = modes != nullptr && modes.use_count() == 1 &&
                              modes->lattice.resolution == lattice.resolution &&
                              modes->lattice.period == lattice.period;
        if (!reusable) modes = std::make_shared<Modes>(empty_terrain_modes(terrain));
        ++runs.filter;
        offset = terrain.mean;
        scale = set_terrain_modes(terrain, *noise, asked_rms(), pool, *modes);
        if (!terrain.range.empty()) fit_range();
        is_filtered = true;
    }

    /// Scales the modes so that the samples of the terrain's own map reach from one end of the
    /// range to the other.
    void fit_range() {
        const Surface map = make_surface(*modes, flat_settings(), 0.0, {Channel::height},
                                         Backend::cpu, pool, terrain.resolution);
        const auto [low, high] = std::ranges::minmax(map.channel(Channel::height));
        const double spread = static_cast<double>(high) - static_cast<double>(low);
        const double gain = spread > 0.0 ? (terrain.range[1] - terrain.range[0]) / spread : 0.0;
        offset = terrain.range[0] - gain * static_cast<double>(low);
        scale = set_terrain_modes(terrain, *noise, gain * scale.rms, pool, *modes);
    }

    std::optional<double> asked_rms() const {
        if (terrain.rms || terrain.has_measured_rms()) return terrain.rms;
        return kDefaultTerrainRms;
    }

    const LandField& shape() {
        if (field != nullptr) return *field;
        require_memory(field_bytes(terrain), "the terrain");
        if (terrain.base_model == nullptr) filter();
        if (terrain.is_shaped()) {
            LandWaves waves;
            if (terrain.base_model == nullptr) waves = {noise.get(), asked_rms(), scale.gain};
            const auto before = carved.land;
            field = std::make_shared<const LandField>(
                build_field(terrain, waves, pool, carved, progress));
            if (carved.land != before) ++runs.streams;
        } else {
            field =
                std::make_shared<const LandField>(build_tile_field(terrain, *modes, offset, pool));
        }
        ++runs.shape;
        return *field;
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

    TerrainModel terrain;
    ThreadPool pool;
    MapWriter writer;
    std::shared_ptr<const TerrainNoise> noise;
    std::shared_ptr<Modes> modes;
    bool is_filtered = false;
    TerrainScale scale;
    double offset = 0.0;
    TerrainRuns runs;
    std::shared_ptr<const LandField> field;
    CarvedLand carved;
    LandProgress progress;

    struct CachedQuery {
        QueryOptions options;
        SurfaceQuery query;
    };
    std::optional<CachedQuery> query;
};

Land::Land(TerrainModel terrain, const LandOptions& options) {
    validate(terrain);
    impl_ = std::make_unique<Impl>(std::move(terrain), options);
}

Land::Land(const Land& shared, const LandOptions& options)
    : impl_(std::make_unique<Impl>(*shared.impl_, options)) {}

Land::~Land() = default;

const TerrainModel& Land::terrain() const {
    return impl_->terrain;
}

void Land::set_terrain(TerrainModel terrain) {
    validate(terrain);
    impl_->go_to(std::move(terrain));
}

void Land::set(std::string_view name, std::string_view value) {
    TerrainModel next = impl_->terrain;
    set_parameter(next, name, value);
    set_terrain(std::move(next));
}

const Modes& Land::modes() {
    impl_->filter();
    return *impl_->modes;
}

double Land::offset() {
    impl_->filter();
    return impl_->offset;
}

TerrainScale Land::scale() {
    impl_->filter();
    return impl_->scale;
}

TerrainState Land::state() {
    TerrainState state;
    if (impl_->terrain.base_model == nullptr) {
        impl_->filter();
        state = terrain_state(impl_->terrain, *impl_->modes, impl_->scale, impl_->offset);
    } else {
        constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
        state.rms.asked = state.rms_slope.asked = kUnknown;
        const Domain land = domain();
        state.longest_wave = std::max(land.size[0], land.size[1]);
        state.memory_bytes = bytes(impl_->terrain);
    }
    if (!impl_->terrain.is_shaped()) return state;
    constexpr int kMaxMeasured = 1024;  // samples: as fine as the land's own grid up to here
    const Domain own = domain();
    const int longer = std::max(own.samples[0], own.samples[1]);
    const Domain measured = longer > kMaxMeasured ? domain(kMaxMeasured) : own;
    measure_shaped(region(measured, {Channel::height, Channel::slope_x, Channel::slope_y}), state);
    state.cell = own.step(0);
    state.shortest_wave = 2.0 * state.cell;
    return state;
}

std::shared_ptr<const LandField> Land::field() {
    impl_->shape();
    return impl_->field;
}

ChannelSet Land::channels() const {
    return terrain_channels(impl_->terrain);
}

Domain Land::domain(int resolution) const {
    return terrain_domain(impl_->terrain, resolution);
}

Surface Land::surface(ChannelSet channels, int resolution) {
    require_terrain_channels(channels, this->channels());
    const Domain domain = this->domain(resolution);
    if (impl_->terrain.is_shaped()) return region(domain, channels);
    require_resolution(domain.samples[0]);
    Surface surface(domain, 0.0, channels);
    surface_into(outputs_of(surface), domain.samples[0]);
    return surface;
}

Surface Land::region(const Domain& region, ChannelSet channels) {
    require_terrain_channels(channels, this->channels());
    const LandField& field = impl_->shape();
    ++impl_->runs.maps;
    return field.surface(region, channels, impl_->pool);
}

void Land::region_into(const Domain& region, std::span<const MapOutput> outputs) {
    require_terrain_channels(channels_of(outputs), channels());
    const LandField& field = impl_->shape();
    ++impl_->runs.maps;
    field.write(region, outputs, impl_->pool);
}

void Land::surface_into(std::span<const MapOutput> outputs, int resolution) {
    require_terrain_channels(channels_of(outputs), channels());
    if (impl_->terrain.is_shaped()) return shaped_into(outputs, resolution);
    if (resolution == 0) resolution = impl_->terrain.resolution;
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

void Land::shaped_into(std::span<const MapOutput> outputs, int resolution) {
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
    const LandField& field = impl_->shape();
    ++impl_->runs.maps;
    field.write(domain, outputs, impl_->pool);
}

void Land::query(std::span<const WorldPoint> points, std::span<QuerySample> samples,
                 const QueryOptions& options) {
    if (impl_->terrain.is_shaped()) {
        const LandField& field = impl_->shape();
        const double cell =
            options.resolution > 0 ? domain(options.resolution).step(0) : domain().step(0);
        return field.query(points, samples, cell, impl_->pool);
    }
    impl_->surface_query(options).sample(points, samples, impl_->pool);
    for (QuerySample& sample : samples.first(points.size())) sample.height += impl_->offset;
}

double Land::query_height_error(const QueryOptions& options) {
    if (impl_->terrain.is_shaped()) return 0.0;  // the function itself is the land
    return impl_->surface_query(options).height_error();
}

const TerrainRuns& Land::runs() const {
    return impl_->runs;
}

ThreadPool& Land::pool() {
    return impl_->pool;
}

ChannelSet terrain_channels(const TerrainModel& terrain) {
    ChannelSet channels = kTerrainChannels;
    const auto add = [&](std::initializer_list<LandMask> masks) {
        for (const LandMask mask : masks) channels = channels | channel_of(mask);
    };
    using enum LandMask;
    if (terrain.has_gullies()) add({wear, gully, ridge});
    if (terrain.has_streams()) add({flow, deposit, streambed, wetness});
    if (terrain.has_coast()) add({beach, cliff, shelter});
    return channels;
}

Domain terrain_domain(const TerrainModel& terrain, int resolution) {
    if (!terrain.is_placed()) {
        return Domain::tile(terrain.patch_size, resolution == 0 ? terrain.resolution : resolution);
    }
    const Domain own = placed_domain(terrain);
    if (resolution == 0) return own;
    return with_cell(own, std::max(own.size[0], own.size[1]) / (resolution - 1));
}

std::uint64_t Land::bytes(const TerrainModel& terrain) {
    if (terrain.is_shaped()) return field_bytes(terrain);
    Grid grid;
    grid.resolution = terrain.resolution;
    return modes_bytes(grid) + lattice_of(terrain).size() / 2 * sizeof(std::complex<float>);
}

}  // namespace ocean
