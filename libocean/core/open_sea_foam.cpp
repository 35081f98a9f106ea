// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The open sea's foam: lattices that are followed over time, what finer maps read of them, and what
// a frame with foam costs.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>

#include "chain.hpp"
#include "ocean/internal/map_request.hpp"
#include "ocean/internal/open_sea.hpp"
#include "waves/surface/map_writer.hpp"

namespace ocean {

double OpenSea::cover_power(double time, int resolution) {
    return cover_power(time, foam_of_map(sea_.parameters, map_resolution(resolution)));
}

double OpenSea::cover_power(double time, const ShownFoam& foam) {
    require_time(time);
    go_to(time);
    return chain_->shown_cover_power(foam, pool_, runs_);
}

void OpenSea::lattice_foam_into(double time, const FoamLattice& lattice, std::span<float> foam) {
    require_time(time);
    require_resolution(lattice.resolution);
    go_to(time);
    require_map_memory(lattice.resolution, 0, Channel::foam);
    ++runs_.surface;
    const FoamLayer layer = foam_layer(time, lattice);
    go_to(time);  // foam has been in the past
    write_lattice_foam(time, lattice, layer, foam);
    keep_foam(layer, lattice);
}

std::int64_t OpenSea::foam_settling_ticks() const {
    std::int64_t ticks = 0;
    for (const auto& [lattice, foam] : foam_) ticks = std::max(ticks, foam.settling_ticks());
    return ticks;
}

FoamLayer OpenSea::foam_layer(double time, const FoamLattice& lattice) {
    const auto [place, is_new] = foam_.try_emplace(
        lattice, foam_clock(sea_.parameters.surface, sea_.parameters.time.loop_period),
        Lattice{lattice.resolution, 1.0}.size(), options_.foam_start);
    const FoamSource source{[this](double t) { return sea_.foam_lifetime(t); },
                            [&](double t, const FoamLayer& before, std::span<float> foam) {
                                go_to(t);
                                ++runs_.foam_ticks;
                                write_lattice_foam(t, lattice, before, foam);
                            },
                            options_.foam_progress};
    return place->second.layer_of_map(time, source);
}

void OpenSea::keep_foam(const FoamLayer& layer, const FoamLattice& lattice) {
    if (layer.kept == nullptr) return;
    ++runs_.foam_ticks;
    foam_.at(lattice).keep();
}

void OpenSea::write_lattice_foam(double time, const FoamLattice& lattice, const FoamLayer& before,
                                 std::span<float> foam) {
    const MapOutput output{foam.data(), 1, {{{Channel::foam, 1.0f}}}};
    if (!lattice.is_spread()) {
        write_maps(time, {&output, 1}, lattice.resolution, before);
        return;
    }
    // Maps of all waves and maps of fewer keep other things of the modes.
    if (!foam_maps_) foam_maps_ = std::make_unique<MapWriter>(options_.backend, options_.channels);
    const SurfaceSettings& settings = chain_->past_settings(lattice, pool_, runs_);
    MapModes modes = modes_of_map(time, lattice.resolution);
    modes.held_by = lattice.held_by;
    if (foam_maps_->write({modes, settings, {&output, 1}, before}, pool_)) ++runs_.packing;
}

FoamLayer OpenSea::spread_layer(double time, const FoamLayer& layer, const FoamLattice& lattice,
                                int resolution) {
    if (layer.fade == 0.0f && layer.kept == nullptr) return {};
    // The lattice's own whitecaps of this moment belong to it: between ticks foam goes on growing.
    lattice_foam_.resize(Lattice{lattice.resolution, 1.0}.size());
    write_lattice_foam(time, lattice, layer, lattice_foam_);
    keep_foam(layer, lattice);
    const double power = chain_->shown_cover_power({lattice, resolution}, pool_, runs_);
    spread_foam_.resize(Lattice{resolution, 1.0}.size());
    spread_foam(lattice_foam_, power, spread_foam_, pool_);
    return {.map = spread_foam_.data(), .fade = 1.0f, .alone = 0.0f};
}

namespace {

double seconds_of(const std::function<void()>& work) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// Returns the seconds of work on a map, measured as the fastest of three on one of `measured`
/// samples a side. An inverse transform of N x N samples is N^2 log N work.
double seconds_of_map(int resolution, int measured, const std::function<void()>& work) {
    work();  // builds all that is missing
    const double scale = std::pow(static_cast<double>(resolution) / measured, 2.0) *
                         std::log(static_cast<double>(resolution)) /
                         std::log(static_cast<double>(measured));
    return scale * std::min({seconds_of(work), seconds_of(work), seconds_of(work)});
}

}  // namespace

FrameCost OpenSea::measure_frame_cost() {
    constexpr int kLargest = 1024;
    const double start = sea_.parameters.time.start;
    const int map = default_map_resolution(sea_.parameters.grid);
    const FoamLattice past = foam_lattice(sea_.parameters, map);
    const int lattice = past.resolution;
    const FoamLattice measured{std::min(lattice, kLargest), std::min(past.held_by, kLargest)};
    go_to(start);
    // As foam is followed: from one map to another that exists.
    const PageVector<float> before(Lattice{measured.resolution, 1.0}.size(), 0.5f);
    PageVector<float> after(before.size());
    const FoamLayer layer{before.data(), 0.99f, 1.0f / 512.0f};
    const double tick = seconds_of_map(lattice, measured.resolution,
                                       [&] { write_lattice_foam(start, measured, layer, after); });
    const ChannelSet channels = {Channel::dx, Channel::dy, Channel::height,  Channel::nx,
                                 Channel::ny, Channel::nz, Channel::whitecap};
    const int measured_map = std::min(map, kLargest);
    double frame =
        seconds_of_map(map, measured_map, [&] { evaluate(start, channels, measured_map); });
    const FoamClock clock = foam_clock(now().surface, now().time.loop_period);
    const double lifetime = now().surface.foam_lifetime;
    const auto preroll =
        static_cast<double>(preroll_ticks(clock, 0, [lifetime](double) { return lifetime; }));
    if (preroll == 0.0) return {frame, frame};  // there are no ticks to follow

    double calibration = 0.0;
    if (past.is_spread()) {
        calibration = seconds_of(
            [&] { chain_->shown_cover_power(foam_of_map(sea_.parameters, map), pool_, runs_); });
        const int small = std::max(1, lattice * kLargest / std::max(map, kLargest));
        const int large = small * (map / lattice);
        const std::vector<float> foam(Lattice{small, 1.0}.size(), 0.5f);
        std::vector<float> spread(Lattice{large, 1.0}.size());
        frame += std::pow(static_cast<double>(map) / large, 2.0) *
                 seconds_of([&] { spread_foam(foam, 3.0, spread, pool_); });
    }
    const double ticks = 1.0 / (now().time.fps * clock.step);
    return {frame + calibration + preroll * tick, frame + std::min(ticks, preroll) * tick};
}

}  // namespace ocean
