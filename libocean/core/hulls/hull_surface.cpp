// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "hulls/hull_surface.hpp"

#include <cstdint>

#include "ocean/internal/cascades.hpp"
#include "ocean/internal/sea_bytes.hpp"
#include "ocean/internal/surface_query.hpp"
#include "ocean/thread_pool.hpp"
#include "waves/query/query_bounds.hpp"

namespace ocean {
namespace {

/// The rms error of reads of the open sea, relative to its significant height.
constexpr double kOpenTolerance = 2e-6;

LinearWaves<Jet> sum_of(const LinearWaves<Jet>& a, const LinearWaves<Jet>& b) {
    return {a.height + b.height, a.displacement_x + b.displacement_x,
            a.displacement_y + b.displacement_y};
}

}  // namespace

HullSurface::HullSurface(const Modes& modes, const Parameters& parameters, int shown, double height,
                         ThreadPool& pool)
    : choppiness_(parameters.surface.choppiness),
      shown_(shown),
      open_reach_(query_bounds(modes, shown, 2 * shown, true, pool).farthest),
      open_(modes, shown, kOpenTolerance * height, pool) {
    for (const Hull& hull : parameters.hulls) {
        wakes_.push_back(
            std::make_unique<Wake>(hull, parameters.water, parameters.time.loop_period, pool));
    }
}

void HullSurface::move_to(const Modes& modes, double time, bool rates, ThreadPool& pool) {
    if (has_begun_ && time == time_ && (rates_ || !rates)) return;
    has_begun_ = false;
    open_.forget();
    open_.move_to(modes, time, rates, pool);
    double farthest = open_reach_;
    for (const auto& wake : wakes_) {
        wake->move_to(time, rates, pool);
        const int waves = wake->size().resolution;
        farthest += query_bounds(wake->modes(), waves, 2 * waves, true, pool).farthest;
    }
    reach_ = choppiness_ * farthest;
    time_ = time;
    rates_ = rates;
    has_begun_ = true;
}

void HullSurface::prepare(double first, double last, ThreadPool& pool) const {
    open_.prepare(first, last, pool);
    for (const auto& wake : wakes_) wake->prepare(first, last, pool);
}

void HullSurface::prepare_sums(const Modes& modes, const Water& water) {
    if (!sum_) sum_.emplace(modes, water, shown_);
    if (sum_time_ != time_) sum_->set_time(time_);
    sum_time_ = time_;
    for (const auto& wake : wakes_) wake->prepare_sums(water);
}

LinearWaves<Jet> HullSurface::waves_at(double x, double y, bool exact) const {
    LinearWaves<Jet> waves = exact ? waves_of<Jet>(sum_->at_label(x, y)) : open_.read<Jet>(x, y);
    for (const auto& wake : wakes_) {
        if (!wake->holds(x, y)) continue;
        waves = sum_of(waves, exact ? wake->read_exactly(x, y) : wake->read(x, y));
    }
    return waves;
}

void HullSurface::read(std::span<const WorldPoint> labels, std::span<LabelPoint> points,
                       bool exact) const {
    const auto chop = static_cast<float>(-choppiness_);
    for (std::size_t i = 0; i < labels.size(); ++i) {
        const LinearWaves<Jet> waves = waves_at(labels[i].x, labels[i].y, exact);
        points[i] = {waves.height, chop * waves.displacement_x, chop * waves.displacement_y};
    }
}

std::uint64_t hull_sea_bytes(const Parameters& parameters) {
    std::uint64_t bytes =
        SurfaceQuery::map_bytes(default_map_resolution(parameters.grid), {.refine = 1});
    for (const Hull& hull : parameters.hulls) bytes += Wake::bytes(hull.wake_resolution);
    return bytes;
}

}  // namespace ocean
