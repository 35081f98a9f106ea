// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
#include "coast.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "coast/surface/region_channels.hpp"
#include "ocean/domain.hpp"
#include "ocean/internal/memory.hpp"
#include "ocean/internal/surf_traces.hpp"

namespace ocean {
namespace {

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

void Coast::drop(const OpenSea::Ended& ended) {
    if (ended.past) traces_.reset();
    if (ended.grid) motion_ = {};
}

CoastSea Coast::sea_at(double time) {
    const DirectionalSpectrum& spectrum = open().spectrum(time);
    return {parameters(), spectrum, open().spectrum_revision(), open().modes(time), shown()};
}

ShoreSurface& Coast::surface(double time, ShoreSurface::Rates rates, const SignalCells* cells) {
    return chain_.surface(sea_at(time), time, rates, open().pool(), open().options().build_progress,
                          cells);
}

CoastChain::Exact Coast::exact(double time) {
    return chain_.exact(sea_at(time), time, open().pool(), open().options().build_progress);
}

void Coast::prepare() {
    chain_.statics(sea_at(parameters().time.start), open().pool(), open().options().build_progress);
}

FoamLayer Coast::surf_layer(SurfTrace trace, double time, SurfReader& reader, FoamState& state) {
    // The whole surface is needed at the time itself.
    const auto surface_at = [this, time](double t,
                                         const SignalCells* cells) -> const ShoreSurface& {
        ++open().stage_runs().foam_ticks;
        return surface(t, ShoreSurface::Rates::without, t == time ? nullptr : cells);
    };
    const double lifetime =
        trace == SurfTrace::foam ? parameters().water.shore.surf_foam_lifetime : kDryingTime;
    return state.layer(time, reader.source(trace, lifetime, surface_at, open().pool(),
                                           open().options().foam_progress));
}

PlacedSea::RegionMaps Coast::region_maps(ChannelSet channels) const {
    const bool has_foam = channels.intersects(kFoamChannels);
    const bool has_wet = channels.contains(channel_of(LandMask::wetness));
    return {(has_foam ? kFoamMaps + 1 : std::size_t{0}) + (has_wet ? kFoamMaps : std::size_t{0}),
            has_foam || has_wet};
}

void Coast::write_region(double time, const Domain& domain, std::span<const MapOutput> outputs) {
    const Parameters& parameters = this->parameters();
    const ChannelSet channels = channels_of(outputs);
    ++open().stage_runs().surface;
    if (!traces_ || traces_->domain != domain) {
        traces_.reset();
        traces_ = std::make_unique<RegionTraces>(domain);
    }
    const FoamStart start = open().options().foam_start;
    RegionFoamMaps foam;
    if (channels.intersects(kFoamChannels)) {
        if (!traces_->foam) traces_->foam.emplace(surf_clock(parameters), domain.count(), start);
        foam.surf = surf_layer(SurfTrace::foam, time, traces_->reader, *traces_->foam);
        foam.open =
            open_map(time, channels.without(kEveryMask | kEveryChannel.without(kFoamChannels)));
    }
    FoamLayer wet;
    if (channels.contains(channel_of(LandMask::wetness))) {
        if (!traces_->wet) traces_->wet.emplace(wet_clock(parameters), domain.count(), start);
        wet = surf_layer(SurfTrace::wet_ground, time, traces_->reader, *traces_->wet);
    }
    ShoreSurface& surface =
        this->surface(time, region_parts(channels) == JetParts::all ? ShoreSurface::Rates::with
                                                                    : ShoreSurface::Rates::without);
    const SurfaceSettings& settings = open().shown_settings(time, shown());
    const RegionChannels writer(surface, channels, settings, foam, wet, bed());
    surface.prepare(open().modes(time), domain, open().pool());
    writer.write(chain_.summed_by(open().options().backend), domain, outputs, open().pool());
}

void Coast::add_foam(double time, std::span<QuerySample> samples,
                     std::span<const ShorePoint> found) {
    std::vector<WorldPoint> labels;
    for (const QuerySample& sample : samples) labels.push_back({sample.label[0], sample.label[1]});
    FoamState state(surf_clock(parameters()), labels.size());
    SurfReader reader([&labels] { return labels; });
    const RegionFoamMaps foam{surf_layer(SurfTrace::foam, time, reader, state),
                              open_map(time, Channel::foam)};
    for (std::size_t i = 0; i < labels.size(); ++i) {
        samples[i].foam =
            static_cast<double>(foam.foam(labels[i], i, found[i].breaking, found[i].surf));
    }
}

const SprayFollower& Coast::spray(double time, const SpraySettings& settings,
                                  const std::optional<Domain>&) {
    const Domain domain = spray_domain(parameters());
    const auto require_room = [&] { require_memory(spray_map_bytes(domain), "spray"); };
    return open().spray(time, settings, domain, require_room, [&](double t, Surface& map) {
        map = region(t, domain, kSprayChannels);
        leave_out_swash(bed(), map);
    });
}

}  // namespace ocean
