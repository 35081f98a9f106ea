// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A terrain as a subject; see terrain_subject.hpp. Everything here hands over to Land and the
// terrain file: no formula of its own.
#include "ocean/terrain_subject.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ocean/cascades.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/memory.hpp"
#include "ocean/terrain_table.hpp"
#include "ocean/terrainfile.hpp"

namespace ocean {
namespace {

LandOptions land_options(const MapsOptions& options) {
    return {.threads = options.threads, .backend = options.backend};
}

Domain domain_of(const Terrain& terrain, TerrainTiles tiles, int resolution) {
    return {{0.0, 0.0},
            {tiles.x * terrain.patch_size, tiles.y * terrain.patch_size},
            {tiles.x * resolution, tiles.y * resolution},
            true};
}

/// Returns the map of one tile repeated.
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

class TerrainMaps final : public SubjectMaps {
  public:
    TerrainMaps(const Terrain& terrain, TerrainTiles tiles, const MapsOptions& options)
        : land_(terrain, land_options(options)), tiles_(tiles) {
        land_.modes();
    }
    TerrainMaps(const TerrainMaps& built, const MapsOptions& options)
        : land_(built.land_, land_options(options)), tiles_(built.tiles_) {}

    Land& land() { return land_; }

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
    WorldHeights heights_by_place(double, int resolution) override {
        return {map({Channel::height}, resolution)};
    }
    void query(double, std::span<const WorldPoint> points, std::span<QuerySample> samples,
               const QueryOptions& options) override {
        land_.query(points, samples, options);
    }
    ThreadPool& pool() override { return land_.pool(); }

  private:
    Surface map(ChannelSet channels, int resolution) {
        Surface tile = land_.surface(channels, resolution);
        if (tiles_ == TerrainTiles{}) return tile;
        return repeated(tile, domain_of(land_.terrain(), tiles_, resolution));
    }

    Land land_;
    TerrainTiles tiles_;
};

class TerrainSubject final : public Subject {
  public:
    TerrainSubject(Terrain terrain, TerrainTiles tiles)
        : terrain_(std::move(terrain)), tiles_(tiles) {}

    const Terrain& terrain() const { return terrain_; }

    std::string_view kind() const override { return kTerrainKind; }
    std::string text() const override { return write_terrain(terrain_); }
    std::vector<std::string> named_files() const override { return ocean::named_files(terrain_); }
    void set(std::string_view name, std::string_view value) override {
        set_parameter(terrain_, name, value);
        validate(terrain_);
    }

    double time_of(double) const override { return 0.0; }
    int first_frame() const override { return 1; }
    double frame_rate() const override { return 24.0; }
    bool plays_take() const override { return false; }
    std::vector<std::string> warnings(double) const override { return {}; }

    ChannelSet channels() const override { return kTerrainChannels; }
    int default_resolution() const override { return terrain_.resolution; }
    Domain domain(int resolution) const override { return domain_of(terrain_, tiles_, resolution); }
    double shortest_wave(int resolution) const override {
        const Lattice lattice{std::min(resolution, terrain_.resolution), terrain_.patch_size};
        return std::max(terrain_.shortest_wavelength, lattice.shortest_wavelength());
    }
    HeightRange height_range() const override {
        Land land(terrain_);
        constexpr double kMaxSigmas = 5.0;  // beyond the highest of 8192^2 samples
        const double reach = kMaxSigmas * land.scale().rms;
        return {land.offset() - reach, land.offset() + reach};
    }

    std::unique_ptr<SubjectMaps> open(const MapsOptions& options) const override {
        return std::make_unique<TerrainMaps>(terrain_, tiles_, options);
    }
    std::uint64_t bytes(int) const override { return Land::bytes(terrain_); }
    std::uint64_t work_bytes(const MapsOptions& options, ChannelSet channels,
                             int resolution) const override {
        return ocean::work_bytes(grid(), options.backend, channels, resolution, options.channels);
    }
    std::uint64_t by_place_bytes(int) const override { return 0; }
    std::uint64_t query_bytes(const QueryOptions& options) const override {
        return SurfaceQuery::map_bytes(terrain_.resolution, options);
    }

  private:
    Grid grid() const {
        Grid grid;
        grid.resolution = terrain_.resolution;
        grid.patch_size = terrain_.patch_size;
        return grid;
    }

    Terrain terrain_;
    TerrainTiles tiles_;
};

}  // namespace

std::unique_ptr<Subject> make_subject(Terrain terrain, TerrainTiles tiles) {
    return std::make_unique<TerrainSubject>(std::move(terrain), tiles);
}

std::unique_ptr<Subject> parse_terrain_subject(std::string_view text, const std::string& name) {
    return make_subject(parse_terrain(text, name, ""));
}

const Terrain* find_terrain(const Subject& subject) {
    const auto* terrain = dynamic_cast<const TerrainSubject*>(&subject);
    return terrain == nullptr ? nullptr : &terrain->terrain();
}

Land& land_of(SubjectMaps& maps) {
    if (auto* terrain = dynamic_cast<TerrainMaps*>(&maps)) return terrain->land();
    throw Error(ErrorKind::unsupported, "this needs the maps of a terrain");
}

}  // namespace ocean
