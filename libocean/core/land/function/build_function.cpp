// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The function of a land, step by step; see build_function.hpp.
#include "land/function/build_function.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "land/function/base_detail.hpp"
#include "land/function/land_function_parts.hpp"
#include "land/function/stream_source.hpp"
#include "ocean/domain.hpp"
#include "ocean/internal/grid.hpp"
#include "ocean/internal/make_surface.hpp"
#include "ocean/internal/shoreline_profile.hpp"
#include "ocean/internal/terrain_base.hpp"
#include "ocean/internal/terrain_law.hpp"
#include "ocean/land_mask.hpp"
#include "ocean/surface.hpp"

namespace ocean {
namespace {

/// A map with four samples for the shortest wave holds the waves of a tile, but no larger map than
/// this.
constexpr int kMaxFineSide = 4096;
int fine_side(int resolution) {
    return std::max(resolution, std::min(2 * resolution, kMaxFineSide));
}

/// Returns the height of waves, without the mean, on a terrain's tile at `origin`.
std::shared_ptr<const SplinePyramid> wave_pyramid(const TerrainModel& terrain, const Modes& modes,
                                                  int side, std::array<double, 2> origin,
                                                  ThreadPool& pool) {
    SurfaceSettings flat;
    flat.choppiness = 0.0;
    const Surface map = make_surface(modes, flat, 0.0, {Channel::height}, Backend::cpu, pool, side);
    Domain domain = Domain::tile(terrain.patch_size, side);
    domain.origin = origin;
    const int oversampled = std::bit_width(static_cast<unsigned>(side / terrain.resolution)) - 1;
    return std::make_shared<const SplinePyramid>(domain, map.channel(Channel::height), pool,
                                                 oversampled);
}

/// Returns the height of a part of a terrain's waves.
std::shared_ptr<const SplinePyramid> part_pyramid(const TerrainModel& terrain,
                                                  const LandWaves& waves, LawPart part, int side,
                                                  std::array<double, 2> origin, ThreadPool& pool) {
    Modes modes = empty_terrain_modes(terrain);
    set_terrain_modes(terrain, *waves.noise, waves.rms, pool, modes, part);
    return wave_pyramid(terrain, modes, side, origin, pool);
}

/// Returns true if waves finer than the smallest gullies fit on the terrain's grid.
bool has_fine_waves(const TerrainModel& terrain) {
    const double smallest = terrain.gullies.longest * std::exp2(1 - terrain.gullies.octaves);
    return terrain.has_gullies() && smallest > lattice_of(terrain).shortest_wavelength();
}

std::array<double, 2> origin_of(const TerrainModel& terrain) {
    if (terrain.origin.size() != 2) return {};
    return {terrain.origin[0], terrain.origin[1]};
}

/// Heights of a placed land on its grid.
struct PlacedGrid {
    Domain domain;
    std::vector<float> heights;
};

/// Returns the heights of a function on the samples of a domain.
template <typename Height>
std::vector<float> sampled(const Domain& domain, ThreadPool& pool, const Height& height) {
    std::vector<float> heights(domain.count());
    const auto columns = static_cast<std::size_t>(domain.samples[0]);
    pool.for_each_range(domain.samples[1], [&](int first, int last) {
        for (int j = first; j < last; ++j) {
            float* const row = heights.data() + static_cast<std::size_t>(j) * columns;
            for (int i = 0; i < domain.samples[0]; ++i) {
                const auto [x, y] = domain.place(i, j);
                row[i] = static_cast<float>(height(x, y));
            }
        }
    });
    return heights;
}

/// Builds a shaped land; each member function is a step.
class Builder {
  public:
    Builder(const TerrainModel& terrain, const LandWaves& waves, ThreadPool& pool,
            CarvedLand& carved, const LandProgress& progress)
        : terrain_(terrain), waves_(waves), pool_(pool), carved_(carved), progress_(progress) {
        parts_.domain = terrain.is_placed() ? placed_domain(terrain)
                                            : Domain::tile(terrain.patch_size, terrain.resolution);
    }

    LandFunction build() {
        report("waves", 0.0);
        if (terrain_.base_model != nullptr) {
            start_from_base();
        } else {
            start_from_waves();
        }
        if (terrain_.has_gullies()) add_gullies();
        if (terrain_.island > 0.0) lower_towards_border();
        if (terrain_.has_streams()) carve_streams();
        if (terrain_.has_coast()) shape_shore();
        add_detail();
        report("waves", 1.0);
        return LandFunction(std::move(parts_));
    }

  private:
    void report(std::string_view work, double share) const {
        if (progress_) progress_(work, share);
    }
    std::function<void(double)> reporter(std::string_view work) const {
        return [this, work](double share) { report(work, share); };
    }

    void start_from_waves() {
        const auto origin = origin_of(terrain_);
        const LawPart part = terrain_.has_gullies() ? LawPart::smooth : LawPart::whole;
        const int side =
            part == LawPart::smooth ? terrain_.resolution : fine_side(terrain_.resolution);
        parts_.base = part_pyramid(terrain_, waves_, part, side, origin, pool_);
        if (has_fine_waves(terrain_)) {
            parts_.fine = part_pyramid(terrain_, waves_, LawPart::fine,
                                       fine_side(terrain_.resolution), origin, pool_);
        }
        parts_.offset = terrain_.mean;
    }

    void start_from_base() {
        Domain domain = terrain_.base_model->model.domain;
        domain.origin = origin_of(terrain_);
        const PageVector<float>& heights = terrain_.base_model->model.heights;
        std::vector<float> moved(heights.begin(), heights.end());
        const double shortest = detail_wavelength(terrain_);
        const BaseDetail detail(*terrain_.base_model, shortest);
        if (detail.has_waves()) {
            parts_.detail = std::make_shared<const FineWaves>(detail.density(), detail.longest(),
                                                              shortest, terrain_.seed, pool_);
            limit_base_shift(domain, moved);
        }
        parts_.base = std::make_shared<const SplinePyramid>(domain, moved, pool_);
        parts_.offset = terrain_.mean;
    }

    /// Subtracts a share of the detail from the samples of the base, so that both together move the
    /// samples by at most base_error [m rms].
    void limit_base_shift(const Domain& domain, std::vector<float>& heights) const {
        const double error = terrain_.base_error.value_or(default_base_error(*terrain_.base_model));
        const double rms = std::sqrt(parts_.detail->variance());
        const double taken = std::max(0.0, 1.0 - error / rms);
        if (taken == 0.0) return;
        const std::vector<float> waves = sampled(domain, pool_, [&](double x, double y) {
            return parts_.detail->at(x - domain.origin[0], y - domain.origin[1], 0.0).height;
        });
        for (std::size_t i = 0; i < heights.size(); ++i) {
            heights[i] -= static_cast<float>(taken) * waves[i];
        }
    }

    void add_gullies() {
        GullySettings settings = terrain_.gullies;
        settings.period = terrain_.is_placed() ? 0.0 : terrain_.patch_size;
        parts_.gullies.emplace(settings);
    }

    /// Replaces the parts that the land has so far by their heights on a grid.
    void replace_by_grid(const Domain& domain, std::span<const float> heights) {
        parts_.base = std::make_shared<const SplinePyramid>(domain, heights, pool_);
        parts_.offset = 0.0;
        parts_.domain = domain;
    }

    /// Returns the heights of the land so far, with gullies and finer waves but without detail.
    std::vector<float> current_heights(const Domain& domain) const {
        LandFunctionParts so_far = parts_;
        so_far.detail = nullptr;
        const Surface map =
            LandFunction(std::move(so_far)).surface(domain, {Channel::height}, pool_);
        const auto heights = map.channel(Channel::height);
        return {heights.begin(), heights.end()};
    }

    void keep(LandMask mask, const Domain& domain, MaskGrid::Values values) {
        parts_.masks.emplace_back(mask,
                                  std::make_shared<const MaskGrid>(domain, std::move(values)));
    }

    void keep(LandMask mask, const Domain& domain, std::span<const float> values) {
        keep(mask, domain, std::make_shared<const PageVector<float>>(values.begin(), values.end()));
    }

    /// Keeps a mask of the streams, whose memory belongs to the carved land.
    void add_stream_mask(LandMask mask, const Domain& domain, const PageVector<float>& values) {
        keep(mask, domain, MaskGrid::Values(carved_.land, &values));
    }

    /// Lowers the base towards the border, before gullies shape it.
    void lower_towards_border() {
        const Domain& domain = parts_.domain;
        const double offset = parts_.offset;
        const std::vector<float> heights = sampled(domain, pool_, [&](double x, double y) {
            const double u = 2.0 * (x - domain.origin[0]) / domain.size[0] - 1.0;
            const double v = 2.0 * (y - domain.origin[1]) / domain.size[1] - 1.0;
            const double cell = domain.step(0);
            return parts_.base->level(cell).value_at(x, y) + offset -
                   terrain_.island * std::hypot(u, v);
        });
        replace_by_grid(domain, heights);
    }

    double level() const { return terrain_.coast_level.value_or(0.0); }

    void carve_streams() {
        const Domain domain = square_domain(1);
        if (carved_.land == nullptr || !same_streams(carved_.of, terrain_)) {
            const auto source =
                stream_source(terrain_, *parts_.base, parts_.offset, domain, level(), pool_);
            carved_.land = std::make_shared<const StreamLand>(
                carve(terrain_.stream, domain.samples[0], domain.samples[1], domain.step(0), source,
                      pool_, reporter("streams")));
            carved_.of = terrain_;
        }
        const StreamLand& land = *carved_.land;
        const std::vector<float> heights =
            with_sea_bed(land, *parts_.base, parts_.offset, domain, level(), pool_);
        replace_by_grid(domain, heights);
        add_stream_mask(LandMask::flow, domain, land.area);
        add_stream_mask(LandMask::deposit, domain, land.deposit);
        add_stream_mask(LandMask::streambed, domain, land.channel);
        add_stream_mask(LandMask::wetness, domain, land.wetness);
    }

    void shape_shore() {
        ShorelineSettings settings = terrain_.coast;
        settings.level = level();
        const int levels = shore_levels(settings);
        const Domain domain = square_domain(1 << levels);
        const std::vector<float> before = current_heights(domain);
        std::vector<float> heights = before;
        const ShorelineMaps maps =
            shape_shoreline(heights, domain, settings, pool_, reporter("shore"));
        parts_.shore = std::make_shared<const ShoreGround>(domain, before, heights, levels, pool_);
        parts_.domain = domain;
        keep(LandMask::beach, domain, maps.beach);
        keep(LandMask::cliff, domain, maps.cliff);
        keep(LandMask::shelter, domain, maps.shelter);
        PageVector<float> share(heights.size());
        constexpr float kUnderWater = 0.3f;  // less sand where waves wash the rock
        for (std::size_t i = 0; i < share.size(); ++i) {
            const bool dry = maps.distance[i] > 0.0f;
            share[i] = (1.0f - maps.beach[i]) * (dry ? 1.0f : kUnderWater);
        }
        parts_.detail_share = std::make_shared<const MaskGrid>(
            domain, std::make_shared<const PageVector<float>>(std::move(share)));
    }

    /// Returns how often the land's grid is halved to have four samples along the smoothing of the
    /// shore line.
    int shore_levels(const ShorelineSettings& settings) const {
        constexpr double kSamplesOfSmoothing = 4.0;
        constexpr int kMaxShoreSide = 8192;
        const Domain& own = parts_.domain;
        const double cell = std::min(own.step(0), own.step(1));
        const double wanted = std::max(settings.smooth, 1.0) / kSamplesOfSmoothing;
        const int side = std::max(own.samples[0], own.samples[1]);
        int levels = 0;
        while (cell > (1.0 + 1e-9) * wanted * (1 << levels) &&
               side << (levels + 1) <= kMaxShoreSide) {
            ++levels;
        }
        return levels;
    }

    /// Returns the land's domain with square cells: the smaller side of its cells, which an
    /// elevation model may have unequal, divided by `factor`.
    Domain square_domain(int factor) const {
        const Domain& own = parts_.domain;
        return with_cell(own, std::min(own.step(0), own.step(1)) / factor);
    }

    /// Adds the waves below the cell of a land without a base, by continuing its law.
    void add_detail() {
        const double shortest = detail_wavelength(terrain_);
        if (shortest <= 0.0 || terrain_.base_model != nullptr) return;
        const double longest = lattice_of(terrain_).shortest_wavelength();
        if (shortest >= longest) return;
        parts_.detail =
            std::make_shared<const FineWaves>(waves_below_lattice(terrain_, waves_.gain, shortest),
                                              longest, shortest, terrain_.seed, pool_);
    }

    const TerrainModel& terrain_;
    const LandWaves& waves_;
    ThreadPool& pool_;
    CarvedLand& carved_;
    const LandProgress& progress_;
    LandFunctionParts parts_;
};

}  // namespace

LandFunction build_function(const TerrainModel& terrain, const LandWaves& waves, ThreadPool& pool,
                            CarvedLand& carved, const LandProgress& progress) {
    return Builder(terrain, waves, pool, carved, progress).build();
}

LandFunction build_tile_function(const TerrainModel& terrain, const Modes& modes, double offset,
                                 ThreadPool& pool) {
    LandFunctionParts parts;
    parts.domain = Domain::tile(terrain.patch_size, terrain.resolution);
    parts.base = wave_pyramid(terrain, modes, fine_side(terrain.resolution), {}, pool);
    parts.offset = offset;
    return LandFunction(std::move(parts));
}

Domain placed_domain(const TerrainModel& terrain) {
    Domain domain{origin_of(terrain), {}, {}, false};
    if (terrain.base_model != nullptr) {
        domain.size = terrain.base_model->model.domain.size;
        domain.samples = terrain.base_model->model.domain.samples;
        return domain;
    }
    const std::array<double, 2> sides = terrain.size.size() == 2
                                            ? std::array{terrain.size[0], terrain.size[1]}
                                            : std::array{terrain.patch_size, terrain.patch_size};
    domain.size = sides;
    return with_cell(domain, std::max(sides[0], sides[1]) / (terrain.resolution - 1));
}

double detail_wavelength(const TerrainModel& terrain) {
    if (terrain.detail_wavelength) return *terrain.detail_wavelength;
    if (terrain.base_model == nullptr) return 0.0;
    constexpr double kPartOfCell = 1.0 / 30.0;
    const Domain& domain = terrain.base_model->model.domain;
    return kPartOfCell * std::max(domain.step(0), domain.step(1));
}

std::uint64_t function_bytes(const TerrainModel& terrain) {
    std::uint64_t bytes = 0;
    const Domain domain = terrain.is_placed()
                              ? placed_domain(terrain)
                              : Domain::tile(terrain.patch_size, terrain.resolution);
    if (terrain.base_model == nullptr) {
        const int side = fine_side(terrain.resolution);
        constexpr std::uint64_t kMap = 2 * sizeof(float);  // the map and its spline, and the levels
        bytes += lattice_of(terrain).size() * sizeof(std::complex<float>) +
                 2 * kMap * Lattice{side, 1.0}.size();
    }
    bytes += 4 * SplinePyramid::bytes(domain);
    if (terrain.has_streams()) bytes += stream_bytes(domain.samples[0], domain.samples[1]);
    if (terrain.has_coast()) bytes += shoreline_bytes(4 * domain.count());
    const double shortest = detail_wavelength(terrain);
    if (shortest > 0.0) bytes += 3 * FineWaves::bytes(FineWaves::kMaxRatio * shortest, shortest);
    return bytes;
}

}  // namespace ocean
