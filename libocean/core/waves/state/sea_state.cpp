// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The numbers of `ocean info`: integrals of the spectrum beside sums over the grid's modes.
#include "ocean/sea_state.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <span>

#include "ocean/channel.hpp"
#include "ocean/internal/cascades.hpp"
#include "ocean/internal/dispersion.hpp"
#include "ocean/internal/foam.hpp"
#include "ocean/internal/sea_bytes.hpp"
#include "ocean/internal/spreading.hpp"
#include "ocean/thread_pool.hpp"
#include "waves/state/mode_sums.hpp"
#include "waves/state/sea_state_text.hpp"

namespace ocean {

namespace {

/// Returns the frequency of the ring with the largest density over omega; 0 for a flat sea.
double peak_of_rings(std::span<const ModeSums> cascades, std::span<const CascadeBand> bands,
                     const Parameters& parameters) {
    const Dispersion dispersion(parameters.water);
    double largest = 0.0;
    double peak = 0.0;
    for (std::size_t c = 0; c < bands.size(); ++c) {
        const ModeSums& sums = cascades[c];
        const double step = kTwoPi * bands[c].divisor / parameters.grid.patch_size;
        for (std::size_t i = 1; i < sums.ring.size(); ++i) {
            const double k = step * static_cast<double>(i);
            const double density = sums.ring[i] / (dispersion.group_velocity(k) * step);
            if (density <= largest) continue;
            largest = density;
            peak = sums.ring_omega[i] / sums.ring[i];
        }
    }
    return peak;
}

/// Returns the bytes of displacement, normals and foam, and of the arrays that make them.
std::uint64_t frame_bytes(const Parameters& parameters, int resolution) {
    using enum Channel;
    const int lattice = foam_lattice(parameters, resolution).resolution;
    const std::uint64_t past =
        maps_bytes(lattice, kFoamMaps) + (lattice < resolution ? maps_bytes(resolution, 1) : 0);
    constexpr ChannelSet kChannels = {dx, dy, height, nx, ny, nz, foam};
    return work_bytes(parameters.grid, Backend::cpu, kChannels, resolution) +
           maps_bytes(resolution, kChannels.size()) + past;
}

/// Returns the share of each cascade. Its waves repeat at its own period, and at the period of any
/// cascade whose divisor divides its own.
std::vector<CascadeShare> cascade_shares(std::span<const ModeSums> cascades,
                                         std::span<const CascadeBand> bands, const ModeSums& total,
                                         double patch_size) {
    std::vector<CascadeShare> shares;
    for (std::size_t c = 0; c < bands.size(); ++c) {
        CascadeShare& share = shares.emplace_back();
        share.period = patch_size / bands[c].divisor;
        share.shortest_wave = cascades[c].shortest;
        share.longest_wave = cascades[c].longest;
        if (total.m0 <= 0.0) continue;
        for (std::size_t other = c; other < bands.size(); ++other) {
            if (bands[other].divisor % bands[c].divisor != 0) continue;
            share.height += cascades[other].m0 / total.m0;
            share.slope += cascades[other].mean_square_slope / total.mean_square_slope;
        }
    }
    return shares;
}

std::vector<MapSlope> map_slopes(const SlopeByMap& slope_by_map) {
    std::vector<MapSlope> slopes;
    double sum = 0.0;
    for (int p = 0; 1 << p <= kMaxResolution; ++p) {
        sum += slope_by_map[static_cast<std::size_t>(p)];
        slopes.push_back({1 << p, sum});
    }
    return slopes;
}

std::vector<LoopError> loop_errors(const Parameters& parameters, double longest, double shortest) {
    std::vector<LoopError> errors;
    if (parameters.time.loop_period <= 0.0) return errors;
    const Dispersion dispersion(parameters.water);
    for (double length = longest; length >= shortest; length *= 0.5) {
        const double omega = dispersion.angular_frequency(kTwoPi / length);
        errors.push_back({length, speed_error(omega, parameters.time.loop_period)});
    }
    return errors;
}

double degrees(double radians) {
    return radians * 180.0 / kPi;
}

}  // namespace

SeaState sea_state(const DirectionalSpectrum& spectrum, const Parameters& parameters,
                   ThreadPool& pool) {
    const SurfaceSettings& surface = parameters.surface;
    const Dispersion dispersion(parameters.water);
    const Grid& grid = parameters.grid;
    const std::vector<CascadeBand> bands = cascade_bands(grid);

    std::vector<ModeSums> cascades;
    ModeSums sums;
    const ModeLattice lattice(parameters, ModeLattice::Memory::none, pool);
    const QuadrantSampler sampler(spectrum);
    for (std::size_t c = 0; c < bands.size(); ++c) {
        cascades.push_back(sum_modes({parameters, lattice, sampler}, spectrum, c, bands[c], pool));
        sums.add(cascades.back());
    }
    const SpectralMoments asked =
        spectrum.moments(parameters.water, surface.shortest_wavelength, surface.longest_wavelength);

    const auto period = [](double omega) { return omega > 0.0 ? kTwoPi / omega : 0.0; };
    const auto wavelength = [&](double omega) {
        return omega > 0.0 ? kTwoPi / dispersion.wavenumber(omega) : 0.0;
    };
    const double peak = peak_of_rings(cascades, bands, parameters);
    SeaState state;
    state.significant_wave_height = {asked.significant_wave_height(), 4.0 * std::sqrt(sums.m0)};
    state.peak_period = {period(asked.peak_omega), period(peak)};
    const auto energy_period = [](const auto& sum) {
        return sum.m0 > 0.0 ? kTwoPi * sum.m_minus1 / sum.m0 : 0.0;
    };
    const auto mean_period = [](const auto& sum) {
        return sum.m1 > 0.0 ? kTwoPi * sum.m0 / sum.m1 : 0.0;
    };
    state.energy_period = {energy_period(asked), energy_period(sums)};
    state.mean_period = {mean_period(asked), mean_period(sums)};
    state.peak_wavelength = {wavelength(asked.peak_omega), wavelength(peak)};
    state.mean_square_slope = {asked.mean_square_slope, sums.mean_square_slope};
    state.map_slopes = map_slopes(sums.slope_by_map);
    state.mean_direction = {degrees(asked.mean_direction), degrees(std::arg(sums.direction))};
    state.directional_spread = {
        degrees(asked.directional_spread),
        sums.m0 > 0.0 ? degrees(circular_spread(std::abs(sums.direction) / sums.m0)) : 0.0};
    state.energy_resolved = asked.m0 > 0.0 ? sums.m0 / asked.m0 : 1.0;
    state.shortest_wave = std::max(sums.shortest, shortest_wave(grid));
    state.longest_wave = sums.longest > 0.0 ? sums.longest : grid.patch_size;
    state.map_resolution = default_map_resolution(grid);
    state.map_shortest_wave =
        std::max(state.shortest_wave, shortest_wave(grid, state.map_resolution));
    state.cascades = cascade_shares(cascades, bands, sums, grid.patch_size);
    state.loop_errors = loop_errors(parameters, state.longest_wave, state.shortest_wave);
    state.loop_error = sums.m0 > 0.0 ? std::sqrt(sums.loop_error / sums.m0) : 0.0;
    state.period = grid.patch_size;
    state.memory_bytes = modes_bytes(grid) + frame_bytes(parameters, state.map_resolution) +
                         spectrum.table().size_bytes();
    const FoamClock clock = foam_clock(surface, parameters.time.loop_period);
    state.foam_preroll_seconds = static_cast<double>(preroll_ticks(
                                     clock, 0, [&](double) { return surface.foam_lifetime; })) *
                                 clock.step;
    const Water& water = parameters.water;
    if (water.bed != nullptr) state.bed = summarize(*water.bed, water);
    add_warnings(parameters, asked.m0 <= 0.0, state);
    state.energy_resolved = std::min(state.energy_resolved, 1.0);  // midpoint sums may exceed it
    return state;
}

void add_whitecaps(const Modes& modes, const SurfaceSettings& settings, SeaState& state) {
    const GradientCovariance covariance = modes.gradient_covariance(state.map_resolution);
    state.foam_threshold = whitecap_threshold(covariance, settings, modes.wind_speed);
    state.whitecap_coverage = {
        monahan_coverage(modes.wind_speed),
        mean_whitecap(covariance, settings.choppiness, state.foam_threshold, settings.foam_width)};
    state.folded_share = folded_share(covariance, settings.choppiness);
    add_folding_warning(settings, state);
}

}  // namespace ocean
