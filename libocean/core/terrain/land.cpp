// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The facade of a terrain; see land.hpp.
#include "ocean/land.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "ocean/error.hpp"
#include "ocean/internal/memory.hpp"
#include "ocean/terrain_table.hpp"
#include "ocean/thread_pool.hpp"
#include "surface/map_writer.hpp"

namespace ocean {
namespace {

/// The settings of a surface without displacement.
SurfaceSettings flat_settings() {
    SurfaceSettings settings;
    settings.choppiness = 0.0;
    return settings;
}

void require_terrain_channels(std::span<const MapOutput> outputs) {
    for (int c = 0; c < kChannelCount; ++c) {
        const auto channel = static_cast<Channel>(c);
        if (kTerrainChannels.contains(channel) || !channels_of(outputs).contains(channel)) continue;
        throw Error(ErrorKind::unsupported, "a terrain has no channel " +
                                                std::string(channel_info(channel).name) +
                                                "; it has height, normals and slopes");
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
    Impl(Terrain its_terrain, const LandOptions& options)
        : terrain(std::move(its_terrain)),
          pool(options.threads, options.run_jobs),
          writer(options.backend) {
        pool.set_interrupt(options.interrupt);
    }
    Impl(const Impl& other, const LandOptions& options)
        : terrain(other.terrain),
          pool(options.threads, options.run_jobs),
          writer(other.writer, {}),
          noise(other.noise),
          modes(other.modes),
          is_filtered(other.is_filtered),
          scale(other.scale),
          offset(other.offset) {
        pool.set_interrupt(options.interrupt);
        if (!(options.backend == other.writer.backend())) writer = MapWriter(options.backend);
    }

    /// Forgets what a change from the present terrain makes stale.
    void go_to(Terrain next) {
        const auto dirty = first_dirty_stage(terrain, next);
        terrain = std::move(next);
        if (!dirty) return;
        if (*dirty == TerrainStage::noise) noise = nullptr;
        if (*dirty <= TerrainStage::filter) {
            is_filtered = false;
            query.reset();
        } else {
            offset = terrain.mean;
        }
    }

    void make_noise() {
        if (noise != nullptr) return;
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
        std::optional<double> rms = terrain.rms;
        if (!rms && !terrain.has_measured_rms()) rms = kDefaultTerrainRms;
        scale = set_terrain_modes(terrain, *noise, rms, pool, *modes);
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

    Terrain terrain;
    ThreadPool pool;
    MapWriter writer;
    std::shared_ptr<const TerrainNoise> noise;
    std::shared_ptr<Modes> modes;
    bool is_filtered = false;
    TerrainScale scale;
    double offset = 0.0;
    TerrainRuns runs;

    struct CachedQuery {
        QueryOptions options;
        SurfaceQuery query;
    };
    std::optional<CachedQuery> query;
};

Land::Land(Terrain terrain, const LandOptions& options) {
    validate(terrain);
    impl_ = std::make_unique<Impl>(std::move(terrain), options);
}

Land::Land(const Land& shared, const LandOptions& options)
    : impl_(std::make_unique<Impl>(*shared.impl_, options)) {}

Land::~Land() = default;

const Terrain& Land::terrain() const {
    return impl_->terrain;
}

void Land::set_terrain(Terrain terrain) {
    validate(terrain);
    impl_->go_to(std::move(terrain));
}

void Land::set(std::string_view name, std::string_view value) {
    Terrain next = impl_->terrain;
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
    impl_->filter();
    return terrain_state(impl_->terrain, *impl_->modes, impl_->scale, impl_->offset);
}

Surface Land::surface(ChannelSet channels, int resolution) {
    if (resolution == 0) resolution = impl_->terrain.resolution;
    require_resolution(resolution);
    require_channels(channels);
    Surface surface(Lattice{resolution, impl_->terrain.patch_size}, 0.0, channels);
    surface_into(outputs_of(surface), resolution);
    return surface;
}

void Land::surface_into(std::span<const MapOutput> outputs, int resolution) {
    if (resolution == 0) resolution = impl_->terrain.resolution;
    require_resolution(resolution);
    require_terrain_channels(outputs);
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

void Land::query(std::span<const WorldPoint> points, std::span<QuerySample> samples,
                 const QueryOptions& options) {
    impl_->surface_query(options).sample(points, samples, impl_->pool);
    for (QuerySample& sample : samples.first(points.size())) sample.height += impl_->offset;
}

double Land::query_height_error(const QueryOptions& options) {
    return impl_->surface_query(options).height_error();
}

const TerrainRuns& Land::runs() const {
    return impl_->runs;
}

ThreadPool& Land::pool() {
    return impl_->pool;
}

std::uint64_t Land::bytes(const Terrain& terrain) {
    Grid grid;
    grid.resolution = terrain.resolution;
    return modes_bytes(grid) + lattice_of(terrain).size() / 2 * sizeof(std::complex<float>);
}

}  // namespace ocean
