// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "coast/surface/coast_chain.hpp"

#include <algorithm>
#include <utility>

#include "ocean/error.hpp"
#include "ocean/internal/memory.hpp"
#include "ocean/internal/platform.hpp"
#include "ocean/sea_bed.hpp"

namespace ocean {
namespace {

/// Returns the part of a water that delays depend on.
Water without_shore(const Water& water) {
    Water part = water;
    part.shore = {};
    return part;
}

}  // namespace

/// Puts pairs before the known ones, of which those that were used first go.
void CoastChain::keep(const std::vector<BandSectorDelays>& pairs) {
    std::vector<BandSectorDelays> kept = pairs;
    std::uint64_t bytes = 0;
    for (const BandSectorDelays& pair : kept) bytes += pair.maps->bytes();
    for (BandSectorDelays& pair : known_) {
        const auto same = [&](const BandSectorDelays& other) { return other.maps == pair.maps; };
        if (std::ranges::any_of(pairs, same)) continue;
        bytes += pair.maps->bytes();
        if (bytes > kKnownBytes) break;
        kept.push_back(std::move(pair));
    }
    known_ = std::move(kept);
}

const ShoreStatics& CoastChain::statics(const CoastSea& sea, ThreadPool& pool,
                                        const BuildProgress& progress) {
    const Water& water = sea.parameters.water;
    const SurfaceSettings& limits = sea.parameters.surface;
    const Source source{water, sea.parameters.grid, limits.shortest_wavelength,
                        limits.longest_wavelength, sea.spectrum_revision};
    if (statics_.delays && made_of_ == source) return statics_;
    const ShoreBands bands = choose_bands(sea.spectrum, sea.parameters);
    if (bands.waves.empty()) {
        throw Error(ErrorKind::invalid_value,
                    "this sea has no waves, so that nothing reaches the coast of its bed");
    }
    const BedGrid bed{water.bed->domain, {water.bed->heights.begin(), water.bed->heights.end()}};
    const auto reports = [&](std::string_view work) -> ShoreProgress {
        if (!progress) return {};
        return [&progress, work](double share) { progress(work, share); };
    };
    surface_.reset();
    statics_ = {};
    if (const Water over = without_shore(water); known_over_ != over) {
        known_.clear();
        known_over_ = over;
    }
    const std::uint64_t bytes = shore_statics_bytes(bed.domain, bands.waves.size());
    if (bytes > available_memory()) known_.clear();
    require_memory(bytes, "the sea over its bed");
    ShoreStatics made;
    made.delays = make_shore_delays(bed, bands, water, pool, reports("coast: delays"), known_);
    keep(made.delays->waves);
    made.energy =
        make_shore_energy(bed, *made.delays, sea.spectrum, water, pool, reports("coast: energy"));
    statics_ = std::move(made);
    made_of_ = source;
    return statics_;
}

/// Returns the surface of the sea, at any time.
ShoreSurface& CoastChain::current_surface(const CoastSea& sea, ShoreSurface::Rates rates,
                                          ThreadPool& pool, const BuildProgress& progress) {
    const ShoreStatics& made = statics(sea, pool, progress);
    const double choppiness = sea.parameters.surface.choppiness;
    const bool has_rates = surface_ && (surface_->rates() == ShoreSurface::Rates::with ||
                                        rates == ShoreSurface::Rates::without);
    const bool is_current = has_rates && surface_modes_ == sea.modes.revision &&
                            surface_choppiness_ == choppiness && surface_shown_ == sea.shown;
    if (!is_current) {
        surface_.reset();
        sums_.reset();
        surface_.emplace(sea.modes, sea.parameters, made, sea.shown, rates, pool);
        surface_modes_ = sea.modes.revision;
        surface_choppiness_ = choppiness;
        surface_shown_ = sea.shown;
        moved_ = false;
    }
    return *surface_;
}

ShoreSurface& CoastChain::surface(const CoastSea& sea, double time, ShoreSurface::Rates rates,
                                  ThreadPool& pool, const BuildProgress& progress,
                                  const SignalCells* cells) {
    ShoreSurface& surface = current_surface(sea, rates, pool, progress);
    const bool lacks_rates = rates == ShoreSurface::Rates::with && !surface.has_rates();
    if (!moved_ || surface.time() != time || lacks_rates || !surface.is_whole()) {
        moved_ = false;
        surface.move_to(time, rates, pool, cells);
        moved_ = true;
    }
    return surface;
}

CoastChain::Exact CoastChain::exact(const CoastSea& sea, double time, ThreadPool& pool,
                                    const BuildProgress& progress) {
    ShoreSurface& surface = current_surface(sea, ShoreSurface::Rates::with, pool, progress);
    if (!sums_) {
        require_memory(2 * WaveSum::bytes(sea.modes, 1), "an exact query of this sea");
        sums_ = surface.sums(sea.modes, sea.parameters.water);
    }
    if (sums_->time != time) sums_->set_time(time);
    return {surface, *sums_};
}

}  // namespace ocean
