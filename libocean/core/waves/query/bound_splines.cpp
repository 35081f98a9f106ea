// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "waves/query/bound_splines.hpp"

#include <array>

#include "waves/query/query_points.hpp"

namespace ocean {

void BoundSplines::begin(const Modes& sea, double choppiness, const Water& water, double time,
                         int shown, bool sums, ThreadPool& pool) {
    if (sea.binding_limit == 0.0) {
        maps_.reset();
        sums_.reset();
        return;
    }
    const Modes& bound = waves_.at(map_modes(sea, time, shown), choppiness, true, pool);
    const int samples = std::min(4 * bound.lattice.resolution, kMaxResolution);
    const ModeFactor factor = spline_factor(bound, shown, samples);
    const bool is_same = maps_ && maps_->spline.lattice().period == bound.lattice.period &&
                         maps_->spline.lattice().resolution == samples;
    if (!is_same || !maps_->strips.repack(bound, factor, pool)) {
        maps_.reset();
        maps_.emplace(bound, samples, factor, pool);
    }
    constexpr std::array<Quantity, 4> kFields = {Linear::height, Linear::height_rate,
                                                 Linear::height_rate, Linear::height_rate};
    const MapOutput output = maps_->spline.output(kFields);
    maps_->strips.begin(bound, 0.0, {&output, 1}, pool);
    maps_->strips.sweep_all(pool);
    sums_.reset();
    if (sums) sums_.emplace(bound, water, shown);
}

std::uint64_t BoundSplines::bytes(int grid_resolution) {
    // A spline of four fields, and between the passes four complex numbers for each ky that bound
    // waves have, an eighth of the spline's.
    constexpr std::uint64_t kFloats = 5;
    const int samples = 4 * std::max(grid_resolution / 2, kMinResolution);
    return BoundWaves::bytes(grid_resolution) +
           kFloats * sizeof(float) * Lattice{samples, 1.0}.size();
}

BoundSample BoundSplines::at(double x, double y) const {
    if (!maps_) return {};
    const double period = maps_->spline.lattice().period;
    const double u = wrapped(x, period);
    for (const int column : maps_->spline.columns(u)) {
        maps_->strips.need(maps_->strips.strip_of(column));
    }
    const SplineJet jet = maps_->spline.jet(u, wrapped(y, period));
    return {static_cast<double>(jet.value[0]) + waves_.mean(), static_cast<double>(jet.by_x[0]),
            static_cast<double>(jet.by_y[0]), static_cast<double>(jet.value[1])};
}

BoundSample BoundSplines::exactly_at(double x, double y) const {
    if (!sums_) return {};
    const LinearSample sample = sums_->at_label(x, y);
    return {sample.height + waves_.mean(), sample.slope_x, sample.slope_y, sample.height_rate};
}

}  // namespace ocean
