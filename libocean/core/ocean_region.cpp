// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The facade's sea over a bed: maps of regions and queries, from the one surface of the coast. Foam
// of breaking waves is followed at labels, as the open sea's is on its lattices.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "chain.hpp"
#include "coast/surface/region_channels.hpp"
#include "coast/surface/shore_query.hpp"
#include "coast/surface/surf_reader.hpp"
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

FoamLayer Ocean::surf_layer(SurfTrace trace, double time, SurfReader& reader, FoamState& state) {
    // With a take other labels may be reached at every time.
    if (!sea_.take.empty()) reader.forget();
    const auto surface_at = [this](double t) -> const ShoreSurface& {
        ++runs_.foam_ticks;
        return shore_surface(t, false);
    };
    const double lifetime =
        trace == SurfTrace::foam ? sea_.parameters.water.shore.surf_foam_lifetime : kDryingTime;
    return state.layer(time,
                       reader.source(trace, lifetime, surface_at, pool_, options_.foam_progress));
}

void Ocean::begin_region(double time, const Domain& domain, ChannelSet channels,
                         std::size_t new_maps) {
    require_time(time);
    require_region(domain);
    require_bed();
    go_to(time);
    const bool has_foam = channels.intersects(kFoamChannels);
    const bool has_wet = channels.contains(channel_of(LandMask::wetness));
    const auto maps = static_cast<std::uint64_t>(new_maps + (has_foam ? kFoamMaps + 1 : 0) +
                                                 (has_wet ? kFoamMaps : 0));
    const std::uint64_t points = has_foam || has_wet ? sizeof(WorldPoint) : 0;
    require_memory(domain.count() * (maps * sizeof(float) + points),
                   "a region of " + std::to_string(domain.samples[0]) + " x " +
                       std::to_string(domain.samples[1]) + " samples");
}

Surface Ocean::region(double time, const Domain& domain, ChannelSet channels) {
    begin_region(time, domain, channels, channels.size());
    Surface map(domain, time, channels);
    write_region(time, domain, outputs_of(map));
    return map;
}

void Ocean::region_into(double time, const Domain& domain, std::span<const MapOutput> outputs) {
    if (!fields_of(outputs).empty()) {
        throw Error(ErrorKind::unsupported,
                    "a region has no linear fields: over a bed waves do not add up");
    }
    begin_region(time, domain, channels_of(outputs), 0);
    write_region(time, domain, outputs);
}

void Ocean::write_region(double time, const Domain& domain, std::span<const MapOutput> outputs) {
    const ChannelSet channels = channels_of(outputs);
    ++runs_.surface;
    if (!region_traces_ || region_traces_->domain != domain) {
        region_traces_.reset();
        region_traces_ = std::make_unique<RegionTraces>(domain);
    }
    RegionTraces& traces = *region_traces_;
    RegionFoamMaps foam;
    if (channels.intersects(kFoamChannels)) {
        if (!traces.foam) {
            traces.foam.emplace(surf_clock(sea_.parameters), domain.count(), options_.foam_start);
        }
        foam.surf = surf_layer(SurfTrace::foam, time, traces.reader, *traces.foam);
        const int shown = default_map_resolution(sea_.parameters.grid);
        foam.open = Surface(Lattice{shown, sea_.parameters.grid.patch_size}, time,
                            channels.without(kEveryMask | kEveryChannel.without(kFoamChannels)));
        write_open(time, outputs_of(foam.open), shown);
    }
    FoamLayer wet;
    if (channels.contains(channel_of(LandMask::wetness))) {
        if (!traces.wet) {
            traces.wet.emplace(wet_clock(sea_.parameters), domain.count(), options_.foam_start);
        }
        wet = surf_layer(SurfTrace::wet_ground, time, traces.reader, *traces.wet);
    }
    ShoreSurface& surface = shore_surface(time, region_parts(channels) == JetParts::all);
    const SurfaceSettings& settings =
        chain_->shown_settings(default_map_resolution(now().grid), pool_, runs_);
    const RegionChannels writer(surface, channels, settings, foam, wet, *now().water.bed);
    surface.prepare(current_modes(), domain, pool_);
    writer.write(coast_->summed_by(options_.backend), domain, outputs, pool_);
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
    SurfReader reader([&labels] { return labels; });
    foam.surf = surf_layer(SurfTrace::foam, time, reader, state);
    const int shown = default_map_resolution(sea_.parameters.grid);
    foam.open = Surface(Lattice{shown, sea_.parameters.grid.patch_size}, time, Channel::foam);
    write_open(time, outputs_of(foam.open), shown);
    for (std::size_t i = 0; i < labels.size(); ++i) {
        samples[i].foam =
            static_cast<double>(foam.foam(labels[i], i, found[i].breaking, found[i].surf));
    }
}

}  // namespace ocean
