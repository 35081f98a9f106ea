// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "hulls/hull_surface.hpp"

#include <array>
#include <cstdint>

#include "ocean/internal/cascades.hpp"
#include "ocean/internal/sea_bytes.hpp"
#include "ocean/internal/surface_query.hpp"
#include "ocean/thread_pool.hpp"
#include "waves/labels/region_rows.hpp"
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

HullSurface::HullSurface(const Parameters& parameters, int shown, double height, ThreadPool& pool)
    : water_(parameters.water),
      choppiness_(parameters.surface.choppiness),
      shown_(shown),
      height_(height) {
    for (const Hull& hull : parameters.hulls) {
        wakes_.push_back(
            std::make_unique<Wake>(hull, parameters.water, parameters.time.loop_period, pool));
    }
}

bool HullSurface::follow(const Parameters& parameters) {
    begun_.reset();
    wakes_begun_.reset();
    for (std::size_t i = 0; i < wakes_.size(); ++i) {
        if (!wakes_[i]->follow(parameters.hulls[i], parameters.water)) return false;
    }
    return true;
}

void HullSurface::renew_open_sea(double height) {
    begun_.reset();
    open_.reset();
    sum_.reset();
    height_ = height;
}

void HullSurface::move_to(const Modes& modes, double time, bool rates, ThreadPool& pool) {
    if (begun_ && begun_->serves(time, rates)) return;
    if (!open_) {
        open_reach_ = query_bounds(modes, shown_, 2 * shown_, true, pool).farthest;
        open_.emplace(modes, shown_, kOpenTolerance * height_, pool);
    }
    move_wakes_to(time, rates, pool);
    begun_.reset();
    open_->forget();
    open_->move_to(modes, time, rates, pool);
    bound_.begin(modes, choppiness_, water_, time, shown_, false, pool);
    double farthest = open_reach_;
    for (const auto& wake : wakes_) {
        farthest += wake->farthest();
    }
    reach_ = choppiness_ * farthest;
    time_ = time;
    begun_ = {time, rates};
}

void HullSurface::move_wakes_to(double time, bool rates, ThreadPool& pool) {
    if (wakes_begun_ && wakes_begun_->serves(time, rates)) return;
    begun_.reset();
    wakes_begun_.reset();
    for (const auto& wake : wakes_) wake->move_to(time, rates, pool);
    wakes_begun_ = {time, rates};
}

void HullSurface::prepare(double first, double last, ThreadPool& pool) const {
    open_->prepare(first, last, pool);
    for (const auto& wake : wakes_) wake->prepare(first, last, pool);
}

void HullSurface::prepare_sums(const Modes& modes, ThreadPool& pool) {
    if (!sum_) sum_.emplace(modes, water_, shown_);
    if (sum_time_ != time_) sum_->set_time(time_);
    sum_time_ = time_;
    bound_.begin(modes, choppiness_, water_, time_, shown_, true, pool);
    for (const auto& wake : wakes_) wake->prepare_sums(water_);
}

LinearWaves<Jet> HullSurface::waves_at(double x, double y, bool exact) const {
    LinearWaves<Jet> waves = exact ? waves_of<Jet>(sum_->at_label(x, y)) : open_->read<Jet>(x, y);
    if (bound_.has_waves()) {
        const BoundSample second = exact ? bound_.exactly_at(x, y) : bound_.at(x, y);
        waves.height +=
            Jet(static_cast<float>(second.height), static_cast<float>(second.slope_x),
                static_cast<float>(second.slope_y), static_cast<float>(second.height_rate));
    }
    for (const auto& wake : wakes_) {
        if (!wake->holds(x, y)) continue;
        waves = sum_of(waves, exact ? wake->read_exactly(x, y) : wake->read(x, y));
    }
    return waves;
}

void HullSurface::read(std::span<const WorldPoint> labels, std::span<LabelPoint> points,
                       bool exact) const {
    for (std::size_t i = 0; i < labels.size(); ++i) {
        points[i] = displayed(waves_at(labels[i].x, labels[i].y, exact));
    }
}

void HullSurface::read_wake(const Wake::Rows& rows, int j, std::size_t first,
                            std::span<LabelPoint> points) const {
    std::array<LinearWaves<Jet>, RegionPiece<LabelPoint>::kSize> waves;
    rows.read(j, first, std::span(waves).first(points.size()));
    for (std::size_t i = 0; i < points.size(); ++i) points[i] = displayed(waves[i]);
}

LabelPoint HullSurface::displayed(const LinearWaves<Jet>& waves) const {
    const auto chop = static_cast<float>(-choppiness_);
    return {waves.height, chop * waves.displacement_x, chop * waves.displacement_y};
}

std::uint64_t hull_sea_bytes(const Parameters& parameters) {
    std::uint64_t bytes =
        SurfaceQuery::map_bytes(default_map_resolution(parameters.grid), {.refine = 1});
    if (parameters.surface.second_order) bytes += BoundSplines::bytes(parameters.grid.resolution);
    for (const Hull& hull : parameters.hulls) bytes += Wake::bytes(hull.wake_resolution);
    return bytes;
}

}  // namespace ocean
