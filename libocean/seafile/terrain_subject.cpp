// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A terrain as a subject; see terrainfile.hpp. This file only calls Terrain and the terrain
// file, and has no formula of its own.
#include "ocean/terrainfile.hpp"

#include <algorithm>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>

#include "ocean/domain.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/cascades.hpp"
#include "ocean/internal/sea_bytes.hpp"
#include "ocean/internal/surface_query.hpp"
#include "ocean/internal/terrain_modes.hpp"
#include "ocean/internal/text.hpp"
#include "ocean/land_function.hpp"
#include "ocean/terrain.hpp"
#include "ocean/terrain_table.hpp"

namespace ocean {
namespace {

TerrainOptions terrain_options(const MapsOptions& options) {
    return {
        .threads = options.threads, .backend = options.backend, .progress = options.build_progress};
}

Domain repeated_domain(const TerrainModel& terrain, TerrainTiles tiles, int resolution) {
    return {{0.0, 0.0},
            {tiles.x * terrain.patch_size, tiles.y * terrain.patch_size},
            {tiles.x * resolution, tiles.y * resolution},
            true};
}

/// Returns the map of repeated tiles, from the map of one.
Surface repeated(const Surface& tile, const Domain& domain) {
    Surface all(domain, tile.time(), tile.channels());
    const auto side = static_cast<std::size_t>(tile.resolution());
    const auto width = static_cast<std::size_t>(domain.samples[0]);
    const auto height = static_cast<std::size_t>(domain.samples[1]);
    for (int c = 0; c < kChannelCount; ++c) {
        const auto channel = static_cast<Channel>(c);
        if (!tile.has(channel)) continue;
        const auto from = std::as_const(tile).channel(channel);
        const auto to = all.channel(channel);
        for (std::size_t j = 0; j < height; ++j) {
            const auto row = from.subspan(j % side * side, side);
            for (std::size_t i = 0; i < width; i += side) {
                std::ranges::copy(row, to.subspan(j * width + i, side).begin());
            }
        }
    }
    return all;
}

/// The part of a terrain that a subject shows: tiles, a placed land as a whole, or a region.
struct TerrainExtent {
    TerrainTiles tiles;
    std::optional<Domain> region;

    /// Returns the domain of a map of `resolution` samples along the side of a tile, or along the
    /// longer side of any other part.
    Domain domain(const TerrainModel& terrain, int resolution) const {
        if (!region) {
            return terrain.is_placed() ? terrain_domain(terrain, resolution)
                                       : repeated_domain(terrain, tiles, resolution);
        }
        const int longer = std::max(region->samples[0], region->samples[1]);
        if (resolution == longer) return *region;
        return with_cell(*region, std::max(region->size[0], region->size[1]) / (resolution - 1));
    }
    int default_resolution(const TerrainModel& terrain) const {
        const Domain shown = region ? *region : terrain_domain(terrain);
        return std::max(shown.samples[0], shown.samples[1]);
    }
};

class TerrainMaps final : public SubjectMaps {
  public:
    TerrainMaps(const TerrainModel& terrain, const TerrainExtent& extent,
                const MapsOptions& options)
        : land_(terrain, terrain_options(options)), extent_(extent) {
        if (extent.region || terrain.is_shaped()) {
            land_.function();
        } else {
            land_.modes();
        }
    }
    TerrainMaps(const TerrainMaps& built, const MapsOptions& options)
        : land_(built.land_, terrain_options(options)), extent_(built.extent_) {}

    Terrain& land() { return land_; }

    std::unique_ptr<SubjectMaps> share(const MapsOptions& options) const override {
        return std::make_unique<TerrainMaps>(*this, options);
    }
    std::vector<Surface> levels(double, ChannelSet channels,
                                std::span<const int> resolutions) override {
        std::vector<Surface> levels;
        for (const int resolution : resolutions) {
            levels.push_back(map(channels, resolution));
        }
        return levels;
    }
    WorldHeights eulerian_heights(double, int resolution) override {
        return {map({Channel::height}, resolution)};
    }
    void query(double, std::span<const WorldPoint> points, std::span<QuerySample> samples,
               const QueryOptions& options) override {
        if (extent_.region) {
            return land_.function()->query(points, samples, extent_.region->step(0), land_.pool());
        }
        land_.query(points, samples, options);
    }
    ThreadPool& pool() override { return land_.pool(); }

  private:
    Surface map(ChannelSet channels, int resolution) {
        const Domain domain = extent_.domain(land_.model(), resolution);
        if (!domain.wraps) return land_.region(domain, channels);
        Surface tile = land_.surface(channels, resolution);
        if (extent_.tiles == TerrainTiles{}) return tile;
        return repeated(tile, domain);
    }

    Terrain land_;
    TerrainExtent extent_;
};

class TerrainSubject final : public Subject {
  public:
    TerrainSubject(TerrainModel terrain, TerrainExtent extent)
        : terrain_(std::move(terrain)), extent_(std::move(extent)) {}

    const TerrainModel& terrain() const { return terrain_; }

    std::string_view kind() const override { return kTerrainKind; }
    std::string text() const override { return write_terrain(terrain_); }
    std::vector<std::string> named_files() const override { return ocean::named_files(terrain_); }
    void set(std::string_view name, std::string_view value) override {
        set_parameter(terrain_, name, value);
        validate(terrain_);
        built_ = nullptr;
    }

    ChannelSet channels() const override { return terrain_channels(terrain_); }
    int default_resolution() const override { return extent_.default_resolution(terrain_); }
    Domain domain(int resolution) const override { return extent_.domain(terrain_, resolution); }
    std::optional<int> backend_resolution(const Backend& backend, int resolution) const override {
        return has_lattice() || backend == Backend::cpu ? std::optional(resolution) : std::nullopt;
    }
    double shortest_wave(int resolution) const override {
        if (!has_lattice()) return 2.0 * domain(resolution).step(0);
        const Lattice lattice{std::min(resolution, terrain_.resolution), terrain_.patch_size};
        return std::max(terrain_.shortest_wavelength, lattice.shortest_wavelength());
    }
    HeightRange height_range(const MapsOptions& options) const override {
        const std::unique_ptr<TerrainMaps> maps = built(options);
        Terrain& land = maps->land();
        if (!has_lattice()) {
            constexpr int kCoarse = 512;
            const Domain own = domain(std::min(default_resolution(), kCoarse));
            const Surface map = land.region(own, {Channel::height});
            const auto [low, high] = std::ranges::minmax(map.channel(Channel::height));
            const double margin = 0.1 * static_cast<double>(high - low) + own.step(0);
            return {static_cast<double>(low) - margin, static_cast<double>(high) + margin};
        }
        constexpr double kMaxSigmas = 5.0;  // higher than the highest of 8192^2 samples
        const double reach = kMaxSigmas * land.scale().rms;
        return {land.offset() - reach, land.offset() + reach};
    }

    std::unique_ptr<SubjectMaps> open(const MapsOptions& options) const override {
        return built(options);
    }
    Costs costs() const override {
        Costs costs{.shared = Terrain::bytes(terrain_)};
        if (has_lattice()) {
            costs.map = [this](const MapsOptions& options, ChannelSet channels, int resolution) {
                return work_bytes(grid(), options.backend, channels, resolution, options.channels);
            };
        }
        if (!terrain_.is_shaped()) {
            costs.query = [this](const QueryOptions& options) {
                return SurfaceQuery::map_bytes(terrain_.resolution, options);
            };
        }
        return costs;
    }

  private:
    /// Returns maps of the land, which is computed once, because streams take as long as all
    /// frames.
    std::unique_ptr<TerrainMaps> built(const MapsOptions& options) const {
        const std::lock_guard lock(mutex_);
        if (built_ != nullptr) return std::make_unique<TerrainMaps>(*built_, options);
        auto maps = std::make_unique<TerrainMaps>(terrain_, extent_, options);
        built_ = std::make_unique<const TerrainMaps>(*maps, MapsOptions{.threads = 1});
        return maps;
    }
    /// Returns true if the terrain is a sum of waves over one period, false if it is a function of
    /// the place.
    bool has_lattice() const { return !extent_.region && !terrain_.is_shaped(); }
    Grid grid() const {
        Grid grid;
        grid.resolution = terrain_.resolution;
        grid.patch_size = terrain_.patch_size;
        return grid;
    }

    TerrainModel terrain_;
    TerrainExtent extent_;
    mutable std::mutex mutex_;
    mutable std::unique_ptr<const TerrainMaps> built_;  // null until first needed
};

}  // namespace

std::unique_ptr<Subject> make_subject(TerrainModel terrain, TerrainTiles tiles) {
    return std::make_unique<TerrainSubject>(std::move(terrain), TerrainExtent{tiles, {}});
}

std::unique_ptr<Subject> make_region_subject(TerrainModel terrain, const Region& region) {
    const Domain domain = domain_of(terrain, region);
    return std::make_unique<TerrainSubject>(std::move(terrain), TerrainExtent{{}, domain});
}

Domain domain_of(const TerrainModel& terrain, const Region& region) {
    const Domain domain = domain_of(region);
    if (!terrain.is_placed()) return domain;
    const Domain land = terrain_domain(terrain);
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const double slack = 1e-6 * land.size[axis];
        const double end = domain.origin[axis] + domain.size[axis];
        const double land_end = land.origin[axis] + land.size[axis];
        if (domain.origin[axis] >= land.origin[axis] - slack && end <= land_end + slack) continue;
        throw Error(ErrorKind::invalid_value,
                    std::string("the region reaches from ") + (axis == 0 ? "x = " : "y = ") +
                        shortest_text(domain.origin[axis]) + " to " + shortest_text(end) +
                        " m, and the land from " + shortest_text(land.origin[axis]) + " to " +
                        shortest_text(land_end) + " m");
    }
    return domain;
}

std::unique_ptr<Subject> parse_terrain_subject(std::string_view text, const std::string& name) {
    return make_subject(parse_terrain(text, name, ""));
}

const TerrainModel* find_terrain(const Subject& subject) {
    const auto* terrain = dynamic_cast<const TerrainSubject*>(&subject);
    return terrain == nullptr ? nullptr : &terrain->terrain();
}

Terrain& terrain_of(SubjectMaps& maps) {
    if (auto* terrain = dynamic_cast<TerrainMaps*>(&maps)) return terrain->land();
    throw Error(ErrorKind::unsupported, "this needs the maps of a terrain");
}

}  // namespace ocean
