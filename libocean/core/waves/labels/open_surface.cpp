// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "waves/labels/open_surface.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "ocean/error.hpp"
#include "ocean/internal/grid.hpp"
#include "ocean/thread_pool.hpp"
#include "waves/query/query_bounds.hpp"
#include "waves/query/query_points.hpp"

namespace ocean {
namespace {

// The fourth quantity of each is not read.
constexpr std::array<Quantity, 4> kPosition = {Linear::displacement_x, Linear::displacement_y,
                                               Linear::height, Linear::height};
constexpr std::array<Quantity, 4> kVelocity = {Linear::displacement_x_rate,
                                               Linear::displacement_y_rate, Linear::height_rate,
                                               Linear::height_rate};
/// The finest spline: 4096^2 samples are 256 MB, of which only the strips near the coast are made.
constexpr int kMaxSamples = 4096;

/// Returns the samples of the spline that OpenSurface chooses.
int spline_samples(const Modes& modes, int shown, double tolerance, ThreadPool& pool) {
    int samples = std::min(2 * shown, kMaxResolution);
    // Waves of cascades that are too short to be shown are not an error of the spline.
    const double hidden = query_bounds(modes, shown, kMaxResolution, true, pool).error;
    const auto variance = [&](int spline) {
        const double error = query_bounds(modes, shown, spline, false, pool).error;
        return error * error - hidden * hidden;
    };
    while (2 * samples <= kMaxSamples && variance(samples) > tolerance * tolerance) samples *= 2;
    return samples;
}

LinearWaves<Jet> from_spline(const SplineJet& jet, const SplineValue& rate) {
    return {.height = {jet.value[2], jet.by_x[2], jet.by_y[2], rate.value[2]},
            .displacement_x = {jet.value[0], jet.by_x[0], jet.by_y[0], rate.value[0]},
            .displacement_y = {jet.value[1], jet.by_x[1], jet.by_y[1], rate.value[1]}};
}

}  // namespace

OpenSurface::OpenSurface(const Modes& modes, int shown, double tolerance, ThreadPool& pool)
    : shown_(shown),
      samples_(spline_samples(modes, shown, tolerance, pool)),
      period_(modes.lattice.period),
      height_error_(query_bounds(modes, shown, samples_, false, pool).error) {}

OpenSurface::OpenSurface(const Modes& modes, int shown, ThreadPool& pool)
    : shown_(shown),
      samples_(2 * shown),
      period_(modes.lattice.period),
      maps_(std::make_unique<Maps>(modes, Lattice{samples_, period_}, ModeFactor(), pool)) {}

ModeFactor OpenSurface::factor(const Modes& modes) const {
    return spline_factor(modes, shown_, samples_);
}

void OpenSurface::move_to(const Modes& modes, double time, bool rates, ThreadPool& pool) {
    if (has_begun_) return;
    const Lattice lattice{samples_, period_};
    if (!maps_) {
        maps_ = std::make_unique<Maps>(modes, lattice, factor(modes), pool);
    }
    if (rates && !maps_->velocity) maps_->velocity.emplace(lattice, pool);
    std::vector<MapOutput> outputs = {maps_->position.output(kPosition)};
    if (rates) outputs.push_back(maps_->velocity->output(kVelocity));
    rates_ = rates;
    maps_->strips.begin(modes, time, outputs, pool);
    maps_->strips.sweep_all(pool);
    has_begun_ = true;
}

void OpenSurface::prepare(double first, double last, ThreadPool& pool) const {
    const double step = period_ / samples_;
    const SplineStrips& strips = maps_->strips;
    TileSet needed(strips.count());
    const double end = std::min(last, first + period_);
    for (double x = first; x < end + strips.width() * step; x += strips.width() * step) {
        for (const int column : maps_->position.columns(wrapped(std::min(x, end), period_))) {
            needed.add(strips.strip_of(column));
        }
    }
    strips.make(needed.list(), &pool);
}

OpenSurface::Place OpenSurface::place(double x, double y) const {
    if (!has_begun_) {
        throw Error(ErrorKind::invalid_value, "the open sea has not been prepared at this label");
    }
    const Place place{wrapped(x, period_), wrapped(y, period_)};
    const SplineStrips& strips = maps_->strips;
    for (const int column : maps_->position.columns(place.x)) strips.need(strips.strip_of(column));
    return place;
}

template <>
LinearWaves<Jet> OpenSurface::read(double x, double y) const {
    const auto [u, v] = place(x, y);
    return from_spline(maps_->position.jet(u, v),
                       rates_ ? maps_->velocity->value(u, v) : SplineValue{});
}

void OpenSurface::Lines::read(double y, std::size_t first,
                              std::span<LinearWaves<Jet>> waves) const {
    const Maps& maps = *surface_.maps_;
    const SplineMap* const rates = surface_.rates_ ? &*maps.velocity : nullptr;
    using Fields = SplineMap::Fields;
    places_.read(maps.position, rates, y, first, waves.size(),
                 [&](std::size_t i, Fields value, Fields by_x, Fields by_y, Fields rate) {
                     const auto jet = [&](int field) {
                         return Jet(Quad{value[field], by_x[field], by_y[field], rate[field]});
                     };
                     waves[i] = {jet(2), jet(0), jet(1)};
                 });
}

template <>
LinearWaves<Plain> OpenSurface::read(double x, double y) const {
    const auto [u, v] = place(x, y);
    const SplineValue at = maps_->position.value(u, v);
    return {.height = at.value[2], .displacement_x = at.value[0], .displacement_y = at.value[1]};
}

}  // namespace ocean
