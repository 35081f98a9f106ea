// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The sum over the waves of a coast at the labels of a block, one band and sector after the other.
#include <array>
#include <cmath>
#include <complex>

#include "coast/surface/shore_block.hpp"
#include "coast/surface/shore_surface.hpp"

namespace ocean {

namespace {

/// Writes the arrays of the parts of a number, which begin at `label`.
template <typename Pointers, typename Jets>
void point_at(Pointers& to, Jets& jets) {
    for (std::size_t p = 0; p < 4; ++p) to[p] = jets.part[p].data();
}

/// Returns a task with the members that all pairs share.
BandSectorTask common_task(JetParts parts, ShoalingBlock& block, const BlockSignal& signal,
                           const QuadBlock& delay) {
    BandSectorTask task{};
    task.count = block.places.count;
    task.parts = parts;
    for (std::size_t field = 0; field < 4; ++field) {
        task.delay[0][field] = delay.value[field].data();
        task.delay[1][field] = delay.by_x[field].data();
        task.delay[2][field] = delay.by_y[field].data();
    }
    point_at(task.re, signal.re);
    point_at(task.im, signal.im);
    point_at(task.real, block.sums.real);
    point_at(task.imaginary, block.sums.imaginary);
    point_at(task.squares, block.sums.squares);
    point_at(task.along_x, block.sums.along_x);
    point_at(task.along_y, block.sums.along_y);
    return task;
}

}  // namespace

void ShoreSurface::find_places(BlockPlaces& places) const {
    const double* const x = places.x.data();
    const double* const y = places.y.data();
    places.delays.find(statics_.domain(), places.count, x, y);
    places.energy.find(statics_.energy->breaking.domain(), places.count, x, y);
}

void ShoreSurface::add_waves(JetParts parts, bool displaces, const ShoreSums* exact,
                             ShoalingBlock& block) const {
    const std::size_t count = block.places.count;
    const bool slopes = parts != JetParts::value;
    QuadBlock delay, amplitudes;
    BlockSignal signal;
    std::array<double, kShoreBlock> place_x, place_y;
    BandSectorTask task = common_task(parts, block, signal, delay);
    task.displaces = displaces;
    for (BlockJets* const sum : block.sums.all()) sum->clear(parts);
    for (std::size_t waves = 0; waves < statics_.bands().waves.size(); ++waves) {
        const ShoreWaves& of = statics_.bands().waves[waves];
        if (waves % 4 == 0) {
            statics_.energy->amplitudes[waves / 4].read(block.places.energy, slopes, amplitudes);
        }
        shift(waves, block.places, slopes, delay, place_x.data(), place_y.data());
        read_signal(waves, count, place_x.data(), place_y.data(), parts, exact, signal);
        task.centre = static_cast<float>(sector_centre(of.sector));
        task.amplitude[0] = amplitudes.value[waves % 4].data();
        task.amplitude[1] = amplitudes.by_x[waves % 4].data();
        task.amplitude[2] = amplitudes.by_y[waves % 4].data();
        const BlockJets& displacement = block.displacement[static_cast<std::size_t>(of.band)];
        for (std::size_t p = 0; p < 3; ++p) task.displacement[p] = displacement.part[p].data();
        band_sector_loop_(task);
        if (displaces) add_left(waves, parts, exact, block);
    }
}

void ShoreSurface::shift(std::size_t waves, const BlockPlaces& places, bool slopes,
                         QuadBlock& delay, double* x, double* y) const {
    statics_.delays->waves[waves].maps->read(places.delays, slopes, delay);
    for (std::size_t n = 0; n < places.count; ++n) {
        x[n] = places.x[n] + static_cast<double>(delay.value[0][n]);
        y[n] = places.y[n] + static_cast<double>(delay.value[1][n]);
    }
}

void ShoreSurface::read_signal(std::size_t waves, std::size_t count, const double* x,
                               const double* y, JetParts parts, const ShoreSums* exact,
                               BlockSignal& signal) const {
    if (exact == nullptr) {
        signals_.read(waves, count, x, y, signal.outputs(parts));
        return;
    }
    for (std::size_t n = 0; n < count; ++n) {
        const ExactSignal at = signals_.exact(waves, exact->time, x[n], y[n]);
        const std::array<std::complex<double>, 4> numbers = {at.value, at.by_x, at.by_y, at.rate};
        for (std::size_t p = 0; p < static_cast<std::size_t>(parts); ++p) {
            signal.re.part[p][n] = static_cast<float>(numbers[p].real());
            signal.im.part[p][n] = static_cast<float>(numbers[p].imag());
        }
    }
}

void ShoreSurface::take_sums(JetParts parts, const ReadySums& ready, ShoalingBlock& block) {
    const float* from = ready.sums.data() + ready.first;
    for (BlockJets* const sum : block.sums.all()) {
        for (std::size_t p = 0; p < static_cast<std::size_t>(parts); ++p, from += ready.labels) {
            for (std::size_t n = 0; n < block.places.count; ++n) {
                sum->part[p][n] = from[block.label[n]];
            }
        }
    }
}

CoastWaves ShoreSurface::waves() const {
    const ShoreDelays& delays = *statics_.delays;
    const ShoreEnergy& energy = *statics_.energy;
    const auto floats = [](std::span<const Quad> quads) {
        return reinterpret_cast<const float*>(quads.data());
    };
    CoastWaves all;
    for (std::size_t i = 0; i < delays.bands.waves.size(); ++i) {
        const ShoreWaves& of = delays.bands.waves[i];
        CoastBandSector& pair = all.pairs.emplace_back();
        pair.band = of.band;
        pair.centre = static_cast<float>(sector_centre(of.sector));
        pair.open_displacement = energy.depths.open_displacement(of.band);
        signals_.describe(i, pair);
    }
    const auto add = [&](QuadMaps& to, const QuadGrid& grid) {
        to.domain = grid.domain();
        to.maps.push_back(floats(grid.quads()));
    };
    for (const BandSectorDelays& pair : delays.waves) add(all.delays, *pair.maps);
    add(all.delays, delays.ground);
    all.delays.owner = statics_.delays;
    for (const QuadGrid& amplitudes : energy.amplitudes) add(all.energy, amplitudes);
    add(all.energy, energy.remainder);
    all.energy.owner = statics_.energy;
    all.displacement = {floats(energy.depths.displacements()),
                        4 * energy.depths.displacements().size()};
    all.first_log = energy.depths.first_log();
    all.per_log = energy.depths.per_log();
    return all;
}

/// Where the open sea fades in, its displacement beside the sectors' middles fades in too.
void ShoreSurface::add_left(std::size_t waves, JetParts parts, const ShoreSums* exact,
                            ShoalingBlock& block) const {
    std::size_t count = 0;
    std::array<std::size_t, kShoreBlock> index;
    std::array<double, kShoreBlock> x, y;
    for (std::size_t n = 0; n < block.places.count; ++n) {
        if (!block.partly[n]) continue;
        x[count] = block.places.x[n];
        y[count] = block.places.y[n];
        index[count++] = n;
    }
    if (count == 0) return;
    BlockSignal signal;
    read_signal(waves, count, x.data(), y.data(), parts, exact, signal);
    const ShoreWaves& of = statics_.bands().waves[waves];
    const double centre = sector_centre(of.sector);
    const auto along_x = static_cast<float>(std::cos(centre));
    const auto along_y = static_cast<float>(std::sin(centre));
    const float open_ratio = statics_.energy->depths.open_displacement(of.band);
    for (std::size_t p = 0; p < static_cast<std::size_t>(parts); ++p) {
        for (std::size_t l = 0; l < count; ++l) {
            const float displacement = open_ratio * signal.im.part[p][l];
            block.sums.left_x.part[p][index[l]] += along_x * displacement;
            block.sums.left_y.part[p][index[l]] += along_y * displacement;
        }
    }
}

}  // namespace ocean
