// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Slope maps of the waves that no shown map holds; see detail_maps.hpp.
#include "waves/detail/detail_maps.hpp"

#include <algorithm>
#include <cmath>

#include "ocean/internal/map_request.hpp"
#include "ocean/internal/sea_bytes.hpp"
#include "ocean/thread_pool.hpp"

namespace ocean {

Detail::Detail(double time, int samples, DetailBudget budget)
    : time_(time), samples_(samples), budget_(std::move(budget)), maps_(budget_.bands.size()) {
    for (PageVector<float>& map : maps_) map.resize(2 * Lattice{samples, 1.0}.size());
}

namespace {

/// Returns the factor that scales the sum over a band's modes to the integral over the band. The
/// factor is limited as in band_gain: whether a band holds the few modes of a narrow swell is left
/// to chance.
double slope_gain(double integral, double sum) {
    return sum > 0.0 ? std::clamp(integral / sum, 0.5, 2.0) : 1.0;
}

/// Sets the variance of a band; returns the gain of its modes' slopes.
double measure(const DetailPlan& plan, const PlannedBand& planned, const ModeLattice& lattice,
               const DirectionalSpectrum& spectrum, ThreadPool& pool, DetailBand& band) {
    const SlopeVariance sum = slopes_of_modes(lattice, spectrum, planned.parameters.grid, pool);
    const double gain = slope_gain(slopes_outside(spectrum, planned.parameters.water, plan.map_edge,
                                                  band.shortest_wave, band.longest_wave),
                                   sum.mean_square_slope());
    band.variance = {gain * sum.x, gain * sum.y, gain * sum.xy};
    return gain;
}

/// Amplifies each wave by the factor that bilinear reading loses. Along one side, with weights 1 -
/// t and t, the mean square over all positions of a wave that turns by p per sample is (2 + cos p)
/// / 3 of the wave's own.
void raise_for_straight_lines(CascadeModes& modes, int samples) {
    const int n = modes.lattice.resolution;
    std::vector<float> raise(static_cast<std::size_t>(n));
    for (std::size_t i = 0; i < raise.size(); ++i) {
        const double waves = static_cast<double>(std::min(i, raise.size() - i));  // a side
        raise[i] = static_cast<float>(std::sqrt(3.0 / (2.0 + std::cos(kTwoPi * waves / samples))));
    }
    auto h0 = modes.h0.begin();
    for (const float along_y : raise) {
        for (const float along_x : raise) *h0++ *= along_x * along_y;
    }
}

double residual_of(const DetailPlan& plan, const Parameters& parameters,
                   const DirectionalSpectrum& spectrum) {
    return slopes_outside(spectrum, parameters.water, plan.map_edge,
                          parameters.surface.shortest_wavelength, plan.rest);
}

}  // namespace

void DetailMaps::set_parameters(const Parameters& parameters, const DirectionalSpectrum& spectrum,
                                const Revision& revision, ThreadPool& pool) {
    const DetailPlan plan = plan_detail(parameters, settings_);
    const bool same_tiles =
        std::ranges::equal(tiles_, plan.bands, [](const Tile& tile, const PlannedBand& planned) {
            return tile.ring == planned.ring && tile.lattice.is_of(planned.parameters);
        });
    if (same_tiles && revision_ == revision) return;
    revision_ = {};
    if (!same_tiles) {
        tiles_.clear();
        for (const PlannedBand& planned : plan.bands) {
            ModeLattice lattice(planned.parameters, planned.ring, planned.noise,
                                ModeLattice::Memory::keep, pool);
            Modes still = lattice.still_modes(pool);
            still.lattice_revision = Revision::begin();
            tiles_.push_back(
                {planned.ring, std::move(lattice), std::move(still), 1.0, MapWriter(backend_)});
        }
    }
    budget_ = {};
    for (std::size_t i = 0; i < plan.bands.size(); ++i) {
        Tile& tile = tiles_[i];
        tile.modes.revision = {};
        DetailBand& band = budget_.bands.emplace_back(plan.bands[i].band);
        tile.gain = measure(plan, plan.bands[i], tile.lattice, spectrum, pool, band);
    }
    budget_.residual = residual_of(plan, parameters, spectrum);
    revision_ = revision;
}

void DetailMaps::write(double time, const DirectionalSpectrum& spectrum,
                       std::span<const MapOutput> outputs, ThreadPool& pool) {
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        if (channels_of(outputs.subspan(i, 1)).empty()) continue;
        Tile& tile = tiles_[i];
        if (!tile.modes.revision) {
            tile.lattice.set_waves(spectrum, 0.0, pool, tile.modes);
            for (CascadeModes& modes : tile.modes.cascades) {
                raise_for_straight_lines(modes, settings_.samples);
            }
            tile.modes.revision = Revision::begin();
        }
        MapOutput output = outputs[i];
        for (auto& [quantity, factor] : output.used()) {
            factor *= static_cast<float>(std::sqrt(tile.gain));
        }
        tile.maps.write({map_modes(tile.modes, time, settings_.samples), {}, {&output, 1}, {}},
                        pool);
    }
}

DetailBudget detail_budget(const Parameters& parameters, const DirectionalSpectrum& spectrum,
                           const DetailSettings& settings, ThreadPool& pool) {
    const DetailPlan plan = plan_detail(parameters, settings);
    DetailBudget budget;
    for (const PlannedBand& planned : plan.bands) {
        const ModeLattice lattice(planned.parameters, planned.ring, planned.noise,
                                  ModeLattice::Memory::none, pool);
        measure(plan, planned, lattice, spectrum, pool, budget.bands.emplace_back(planned.band));
    }
    budget.residual = residual_of(plan, parameters, spectrum);
    return budget;
}

std::uint64_t detail_bytes(const Parameters& parameters, const DetailSettings& settings,
                           const Backend& backend) {
    constexpr ChannelSet kSlopes = {Channel::slope_x, Channel::slope_y};
    std::uint64_t bytes = 0;
    for (const PlannedBand& planned : plan_detail(parameters, settings).bands) {
        const Grid& grid = planned.parameters.grid;
        bytes += modes_bytes(grid) + ModeLattice::kept_bytes(grid) +
                 work_bytes(grid, backend, kSlopes, settings.samples);
    }
    return bytes;
}

}  // namespace ocean
