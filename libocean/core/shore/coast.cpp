// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "shore/coast.hpp"

#include <algorithm>

#include "ocean/error.hpp"
#include "ocean/internal/memory.hpp"
#include "ocean/sea_bed.hpp"

namespace ocean {
namespace {

bool same_waves(const std::vector<ShoreWaves>& a, const std::vector<ShoreWaves>& b) {
    return std::ranges::equal(a, b, [](const ShoreWaves& x, const ShoreWaves& y) {
        return x.band == y.band && x.sector == y.sector;
    });
}

}  // namespace

const ShoreStatics& Coast::statics(const CoastSea& sea, ThreadPool& pool,
                                   const BuildProgress& progress) {
    const Water& water = sea.parameters.water;
    const bool same_bed = statics_.delays && water == made_of_.water;
    if (same_bed && made_of_.spectrum == sea.spectrum_revision) return statics_;
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
    const bool same_division =
        same_bed && bands.edges == made_of_.edges && same_waves(bands.waves, made_of_.waves);
    made_of_.spectrum = {};
    if (!same_division) {
        statics_ = {};
        require_memory(shore_statics_bytes(bed.domain, bands.waves.size()), "the sea over its bed");
        statics_.delays = make_shore_delays(bed, bands, water, pool, reports("coast: delays"));
    } else {
        // The division is the same, the variances are not.
        auto delays = std::make_shared<ShoreDelays>(*statics_.delays);
        delays->bands = bands;
        statics_.delays = std::move(delays);
    }
    statics_.energy = make_shore_energy(bed, *statics_.delays, sea.spectrum, water, pool,
                                        reports("coast: energy"));
    made_of_ = {water, bands.waves, bands.edges, sea.spectrum_revision};
    return statics_;
}

ShoreSurface& Coast::surface(const CoastSea& sea, double time, ShoreSurface::Rates rates,
                             ThreadPool& pool, const BuildProgress& progress) {
    const ShoreStatics& made = statics(sea, pool, progress);
    const double choppiness = sea.parameters.surface.choppiness;
    const bool has_rates = surface_ && (surface_->rates() == ShoreSurface::Rates::with ||
                                        rates == ShoreSurface::Rates::without);
    const bool is_current = has_rates && surface_modes_ == sea.modes.revision &&
                            surface_choppiness_ == choppiness && surface_shown_ == sea.shown;
    if (!is_current) {
        surface_.reset();
        surface_.emplace(sea.modes, sea.parameters, made, sea.shown, rates, pool);
        surface_modes_ = sea.modes.revision;
        surface_choppiness_ = choppiness;
        surface_shown_ = sea.shown;
        moved_ = false;
    }
    if (!moved_ || surface_->time() != time) {
        moved_ = false;
        surface_->move_to(time, pool);
        moved_ = true;
    }
    return *surface_;
}

}  // namespace ocean
