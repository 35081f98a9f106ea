// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The facade's sea over a bed: maps of regions and queries, from the one surface of the coast. Foam
// of breaking waves is followed at labels, as the open sea's is on its lattices.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "chain.hpp"
#include "coast/surface/region_channels.hpp"
#include "coast/surface/shore_query.hpp"
#include "coast/surface/surf_labels.hpp"
#include "ocean/cascades.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/memory.hpp"
#include "ocean/land_mask.hpp"
#include "ocean/ocean.hpp"
#include "ocean/region.hpp"
#include "ocean/sea_bed.hpp"
#include "ocean/surf_traces.hpp"
#include "ocean_coast.hpp"
#include "waves/query/query_points.hpp"

namespace ocean {
namespace {

constexpr ChannelSet kFoamChannels = {Channel::foam, Channel::cover};

void require_region(const Domain& domain) {
    const auto is_side = [&](std::size_t axis) {
        return domain.samples[axis] >= 2 && domain.samples[axis] <= kMaxRegionSide &&
               std::isfinite(domain.origin[axis]) && std::isfinite(domain.size[axis]) &&
               domain.size[axis] > 0.0;
    };
    if (!domain.wraps && is_side(0) && is_side(1)) return;
    throw Error(ErrorKind::invalid_value,
                "the region has " + std::to_string(domain.samples[0]) + " x " +
                    std::to_string(domain.samples[1]) +
                    " samples; allowed: a rectangle that does not wrap, 2 .. " +
                    std::to_string(kMaxRegionSide) + " samples along each side");
}

std::vector<WorldPoint> labels_of(const Domain& domain) {
    std::vector<WorldPoint> labels(domain.count());
    std::size_t next = 0;
    for (int j = 0; j < domain.samples[1]; ++j) {
        for (int i = 0; i < domain.samples[0]; ++i) {
            const auto [x, y] = domain.place(i, j);
            labels[next++] = {x, y};
        }
    }
    return labels;
}

enum class SurfTrace { foam, wet_ground };

/// Writes what waves that break and run up leave, of one tick: what is left of that before, or what
/// comes now.
void add_trace(SurfTrace trace, const ShoreSurface& surface, std::span<const SurfLabels> surf,
               const FoamLayer& before, std::span<float> left, ThreadPool& pool) {
    std::ranges::fill(left, 0.0f);
    pool.for_each_item(static_cast<int>(surf.size()), [&](int piece, int) {
        const SurfLabels& labels = surf[static_cast<std::size_t>(piece)];
        std::vector<float> breaking(labels.size());
        std::vector<float> depths(labels.size());
        surface.read_surf(labels, breaking, depths);
        for (std::size_t n = 0; n < labels.size(); ++n) {
            const std::size_t i = labels.index[n];
            const float past = before.map == nullptr ? 0.0f : before.fade * before.map[i];
            const float now = trace == SurfTrace::foam ? breaking[n] : covered_by(depths[n]);
            const float here = std::max(now, past);
            left[i] = here < before.cutoff ? 0.0f : here;
        }
    });
}

/// Returns the source of a trace at labels, whose lifetime [s] does not change. `surface_at`
/// returns the surface of a time; the labels that waves reach are found at the first tick.
FoamSource trace_source(SurfTrace trace, std::span<const WorldPoint> labels, double lifetime,
                        const std::function<const ShoreSurface&(double time)>& surface_at,
                        ThreadPool& pool,
                        const std::function<void(std::int64_t, std::int64_t)>& progress) {
    return {[lifetime](double) { return lifetime; },
            [=, &pool, surf = std::vector<SurfLabels>()](double t, const FoamLayer& before,
                                                         std::span<float> left) mutable {
                const ShoreSurface& surface = surface_at(t);
                if (surf.empty()) {
                    surf = find_surf(surface.statics(), surface.run_up(), labels, pool);
                }
                add_trace(trace, surface, surf, before, left, pool);
            },
            progress};
}

/// The clock of the foam of breaking waves: their fronts are some metres wide, so that a quarter of
/// a second passes no gap.
FoamClock surf_clock(const Parameters& parameters) {
    constexpr double kLeastStep = 0.25;  // [s]
    SurfaceSettings settings = parameters.surface;
    settings.foam_step = std::max(settings.foam_step, kLeastStep);
    return foam_clock(settings, parameters.time.loop_period);
}

/// The clock of wet sand, which swash covers for seconds and which dries slowly.
FoamClock wet_clock(const Parameters& parameters) {
    SurfaceSettings settings = parameters.surface;
    settings.foam_step = 1.0;
    return foam_clock(settings, parameters.time.loop_period);
}

}  // namespace

void Ocean::require_open_sea(std::string_view what) const {
    if (!sea_.parameters.water.bed) return;
    throw Error(ErrorKind::unsupported,
                std::string(what) +
                    " repeats or knows no depth, and this sea has a bed (water.seabed), over which "
                    "it does not repeat; request a region");
}

ShoreSurface& Ocean::shore_surface(double time, bool with_rates) {
    const auto rates = with_rates ? ShoreSurface::Rates::with : ShoreSurface::Rates::without;
    return with_coast_sea(time, [&](const CoastSea& sea) -> ShoreSurface& {
        return coast_->surface(sea, time, rates, pool_, options_.build_progress);
    });
}

void Ocean::require_bed() const {
    if (sea_.parameters.water.bed) return;
    throw Error(ErrorKind::unsupported,
                "this sea has no bed (water.seabed): it repeats, and its maps are those of one "
                "period");
}

void Ocean::prepare_coast() {
    require_bed();
    with_coast_sea(sea_.parameters.time.start, [&](const CoastSea& sea) {
        coast_->statics(sea, pool_, options_.build_progress);
    });
}

FoamLayer Ocean::surf_foam(double time, std::span<const WorldPoint> labels, FoamState& state) {
    const double lifetime = sea_.parameters.water.shore.surf_foam_lifetime;
    const auto surface_at = [this](double t) -> const ShoreSurface& {
        ++runs_.foam_ticks;
        return shore_surface(t, false);
    };
    return state.layer(time, trace_source(SurfTrace::foam, labels, lifetime, surface_at, pool_,
                                          options_.foam_progress));
}

FoamLayer Ocean::wet_ground(double time, std::span<const WorldPoint> labels, FoamState& state) {
    const auto surface_at = [this](double t) -> const ShoreSurface& {
        ++runs_.foam_ticks;
        return shore_surface(t, false);
    };
    return state.layer(time, trace_source(SurfTrace::wet_ground, labels, kDryingTime, surface_at,
                                          pool_, options_.foam_progress));
}

Surface Ocean::region(double time, const Domain& domain, ChannelSet channels) {
    require_time(time);
    require_region(domain);
    require_bed();
    go_to(time);
    const bool has_foam = channels.intersects(kFoamChannels);
    const bool has_wet = channels.contains(channel_of(LandMask::wetness));
    const auto maps = static_cast<std::uint64_t>(channels.size() + (has_foam ? kFoamMaps + 1 : 0) +
                                                 (has_wet ? kFoamMaps : 0));
    const std::uint64_t points = has_foam || has_wet ? sizeof(WorldPoint) : 0;
    require_memory(domain.count() * (maps * sizeof(float) + points),
                   "a region of " + std::to_string(domain.samples[0]) + " x " +
                       std::to_string(domain.samples[1]) + " samples");
    ++runs_.surface;
    RegionFoamMaps foam;
    if (has_foam) {
        if (!region_foam_ || region_foam_->domain != domain) {
            region_foam_.emplace(RegionFoam{
                domain,
                FoamState(surf_clock(sea_.parameters), domain.count(), options_.foam_start)});
        }
        foam.surf = surf_foam(time, labels_of(domain), region_foam_->state);
        const int shown = default_map_resolution(sea_.parameters.grid);
        foam.open = Surface(Lattice{shown, sea_.parameters.grid.patch_size}, time,
                            channels.without(kEveryMask | kEveryChannel.without(kFoamChannels)));
        write_open(time, outputs_of(foam.open), shown);
    }
    FoamLayer wet;
    if (has_wet) {
        if (!region_wet_ || region_wet_->domain != domain) {
            region_wet_.emplace(RegionFoam{domain, FoamState(wet_clock(sea_.parameters),
                                                             domain.count(), options_.foam_start)});
        }
        wet = wet_ground(time, labels_of(domain), region_wet_->state);
    }
    ShoreSurface& surface = shore_surface(time, region_parts(channels) == JetParts::all);
    const SurfaceSettings& settings =
        chain_->shown_settings(default_map_resolution(now().grid), pool_, runs_);
    const RegionChannels writer(surface, channels, settings, foam, wet, *now().water.bed);
    Surface map(domain, time, channels);
    surface.prepare(current_modes(), domain, pool_);
    writer.write(coast_->summed_by(options_.backend), map, pool_);
    return map;
}

void Ocean::query_shore(double time, std::span<const WorldPoint> points,
                        std::span<QuerySample> samples, const QueryOptions& options) {
    require_finite(points);
    require_query_of_coast(sea_.parameters.grid, options);
    if (points.empty()) return;
    std::vector<ShorePoint> found(points.size());
    if (options.exact) {
        with_coast_sea(time, [&](const CoastSea& sea) {
            const Coast::Exact exact = coast_->exact(sea, time, pool_, options_.build_progress);
            ocean::query_shore(exact.surface, points, samples, found, &exact.sums, pool_);
        });
    } else {
        ShoreSurface& surface = shore_surface(time, true);
        const auto [west, east] = std::ranges::minmax(points, {}, &WorldPoint::x);
        surface.prepare(current_modes(), west.x - surface.reach(), east.x + surface.reach(), pool_);
        ocean::query_shore(surface, points, samples, found, nullptr, pool_);
    }
    if (!options.foam) return;
    std::vector<WorldPoint> labels;
    for (const QuerySample& sample : samples.first(points.size())) {
        labels.push_back({sample.label[0], sample.label[1]});
    }
    FoamState state(surf_clock(sea_.parameters), labels.size());
    RegionFoamMaps foam;
    foam.surf = surf_foam(time, labels, state);
    const int shown = default_map_resolution(sea_.parameters.grid);
    foam.open = Surface(Lattice{shown, sea_.parameters.grid.patch_size}, time, Channel::foam);
    write_open(time, outputs_of(foam.open), shown);
    for (std::size_t i = 0; i < labels.size(); ++i) {
        samples[i].foam =
            static_cast<double>(foam.foam(labels[i], i, found[i].breaking, found[i].surf));
    }
}

}  // namespace ocean
