// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "hulls/wake.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/simd/simd_level.hpp"
#include "field/ease.hpp"
#include "ocean/internal/hull_rules.hpp"
#include "ocean/internal/surface_query.hpp"
#include "ocean/thread_pool.hpp"

namespace ocean {
namespace {

// The wake fades to 0 between these shares of its square, from the centre. The window has ended
// nearly all of it before.
constexpr double kRimBegin = 0.46;
constexpr double kRimEnd = 0.495;

/// Any error of the spline will do: it has the least samples, twice the lattice's.
constexpr double kAnyError = std::numeric_limits<double>::infinity();

/// Returns the factor of one axis, with its slope as the first of the jet's derivatives.
struct RimFactor {
    double value;
    double slope;  // [1/m]
};
RimFactor rim_factor(double offset, double side) {
    const double share = std::abs(offset) / side;
    const double u = (share - kRimBegin) / (kRimEnd - kRimBegin);
    if (u <= 0.0) return {1.0, 0.0};
    if (u >= 1.0) return {0.0, 0.0};
    const double rise = 30.0 * u * u * (1.0 - u) * (1.0 - u) / (kRimEnd - kRimBegin) / side;
    return {1.0 - ease_quintic(u), offset < 0.0 ? rise : -rise};
}

LinearWaves<Jet> within_rim(const LinearWaves<Jet>& waves, double x, double y, double side) {
    const RimFactor along = rim_factor(x, side);
    const RimFactor across = rim_factor(y, side);
    if (along.value == 1.0 && across.value == 1.0) return waves;
    const Jet factor(static_cast<float>(along.value * across.value),
                     static_cast<float>(along.slope * across.value),
                     static_cast<float>(along.value * across.slope));
    return {factor * waves.height, factor * waves.displacement_x, factor * waves.displacement_y};
}

Jet with_rate(const Jet& value, float rate) {
    return {value.value(), value.by_x(), value.by_y(), rate};
}

}  // namespace

Wake::Wake(const Hull& hull, const Water& water, double loop_period, ThreadPool& pool)
    : size_(wake_size(hull, fastest_leg(*hull.track).speed, water)),
      path_(hull.track, loop_period),
      lattice_(hull, size_, water),
      waves_(lattice_.still_modes()),
      rates_(lattice_.still_modes()),
      map_(waves_, size_.resolution, kAnyError, pool),
      rate_map_(rates_, size_.resolution, kAnyError, pool),
      amplitudes_(4 * lattice_.count()),
      half_length_(0.5 * hull.length) {}

void Wake::move_to(double time, bool rates, ThreadPool& pool) {
    const double step = size_.side / size_.resolution;
    past_ = wake_past(path_, time, size_.age, size_.side, step);
    has_rates_ = rates;
    sum_.reset();
    rate_sum_.reset();
    const std::size_t count = lattice_.count();
    const WakeLoop loop = wake_loop(simd_level());
    float* const re = amplitudes_.data();
    const auto groups = static_cast<int>(count / kWakeBlock);
    pool.for_each_range(groups, [&](int first, int last) {
        const std::size_t from = static_cast<std::size_t>(first) * kWakeBlock;
        loop({.count = static_cast<std::size_t>(last - first) * kWakeBlock,
              .velocities = lattice_.velocities() + first,
              .n = lattice_.n() + from,
              .m = lattice_.m() + from,
              .rate_high = lattice_.rate_high() + from,
              .rate_low = lattice_.rate_low() + from,
              .group_x = lattice_.group_x() + from,
              .group_y = lattice_.group_y() + from,
              .gain = lattice_.gain() + from,
              .runs = past_.runs.data(),
              .run_count = past_.runs.size(),
              .ages = past_.ages.data(),
              .size = size_.side,
              .half_length = half_length_,
              .hull_x = past_.hull.x,
              .hull_y = past_.hull.y,
              .velocity_x = past_.velocity.x,
              .velocity_y = past_.velocity.y,
              .re = re + from,
              .im = re + count + from,
              .rate_re = rates ? re + 2 * count + from : nullptr,
              .rate_im = rates ? re + 3 * count + from : nullptr});
    });
    const auto begin = [&](Modes& modes, const float* from, OpenSurface& map) {
        lattice_.set_amplitudes(from, from + count, modes);
        map.forget();
        map.repack(modes, pool);
        map.move_to(modes, 0.0, false, pool);
    };
    begin(waves_, re, map_);
    if (rates) begin(rates_, re + 2 * count, rate_map_);
}

void Wake::prepare(double first, double last, ThreadPool& pool) const {
    const double half = kRimEnd * size_.side;
    const double from = std::max(first - past_.place.centre.x, -half);
    const double to = std::min(last - past_.place.centre.x, half);
    if (from > to) return;
    map_.prepare(from, to, pool);
    if (has_rates_) rate_map_.prepare(from, to, pool);
}

bool Wake::holds(double x, double y) const {
    const double half = kRimEnd * size_.side;
    return std::abs(x - past_.place.centre.x) < half && std::abs(y - past_.place.centre.y) < half;
}

double Wake::share_at(double x, double y) const {
    return rim_factor(x - past_.place.centre.x, size_.side).value *
           rim_factor(y - past_.place.centre.y, size_.side).value;
}

LinearWaves<Jet> Wake::read(double x, double y) const {
    const double u = x - past_.place.centre.x;
    const double v = y - past_.place.centre.y;
    LinearWaves<Jet> waves = map_.read<Jet>(u, v);
    if (has_rates_) {
        const LinearWaves<Plain> rates = rate_map_.read<Plain>(u, v);
        waves = {with_rate(waves.height, rates.height.value()),
                 with_rate(waves.displacement_x, rates.displacement_x.value()),
                 with_rate(waves.displacement_y, rates.displacement_y.value())};
    }
    return within_rim(waves, u, v, size_.side);
}

void Wake::prepare_sums(const Water& water) {
    if (sum_) return;
    sum_.emplace(waves_, water);
    rate_sum_.emplace(rates_, water);
}

LinearWaves<Jet> Wake::read_exactly(double x, double y) const {
    const double u = x - past_.place.centre.x;
    const double v = y - past_.place.centre.y;
    LinearSample at = sum_->at_label(u, v);
    const LinearSample rate = rate_sum_->at_label(u, v);
    at.height_rate = rate.height;
    at.displacement_x_rate = rate.displacement_x;
    at.displacement_y_rate = rate.displacement_y;
    return within_rim(waves_of<Jet>(at), u, v, size_.side);
}

std::uint64_t Wake::bytes(int resolution) {
    return WakeLattice::bytes(resolution) + 2 * SurfaceQuery::map_bytes(resolution, {.refine = 1});
}

WakeSteepness wake_steepness(const Hull& hull, const Water& water, double loop_period,
                             ThreadPool& pool) {
    const auto [speed, time] = fastest_leg(*hull.track);
    if (!(speed > 0.0)) return {};
    Wake wake(hull, water, loop_period, pool);
    wake.move_to(time, false, pool);
    const TrackPath path(hull.track, loop_period);
    const PathVector at = path.place(time);
    const PathVector before = path.place(time - kWakeTick);
    const double way = std::max(std::hypot(at.x - before.x, at.y - before.y), 1e-9);
    const PathVector ahead{(at.x - before.x) / way, (at.y - before.y) / way};
    float lowest = 0.0f, highest = 0.0f;
    const double step = wake.size().side / wake.size().resolution;
    for (double back = 0.0; back < 0.5 * wake.size().side; back += step) {
        for (const double side : {-hull.length, hull.length}) {
            const double x = at.x - back * ahead.x - side * ahead.y;
            const double y = at.y - back * ahead.y + side * ahead.x;
            if (!wake.holds(x, y)) continue;
            const float height = wake.read(x, y).height.value();
            lowest = std::min(lowest, height);
            highest = std::max(highest, height);
        }
    }
    // Two thirds of the transverse waves' length, where both kinds meet.
    const double length = 2.0 / 3.0 * kTwoPi * speed * speed / water.gravity;
    const auto height = static_cast<double>(highest - lowest);
    return {height, height / length};
}

}  // namespace ocean
