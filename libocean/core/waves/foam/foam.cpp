// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Foam over time: its clock, how far back it must be followed, and the state of a caller that
// steps. This is the stage between the whitecap maps of the surface and the foam map that hosts
// show.
#include "ocean/internal/foam.hpp"

#include <algorithm>
#include <cmath>

namespace ocean {

FoamClock foam_clock(const SurfaceSettings& settings, double loop_period) {
    if (loop_period <= 0.0) return {settings.foam_step, 0.0, 0};
    const double ticks = std::max(1.0, std::round(loop_period / settings.foam_step));
    return {loop_period / ticks, loop_period, static_cast<std::int64_t>(ticks)};
}

double FoamClock::time_of(std::int64_t tick) const {
    if (ticks_per_loop == 0) return static_cast<double>(tick) * step;
    return static_cast<double>(tick) / static_cast<double>(ticks_per_loop) * loop_period;
}

FoamClock::Moment FoamClock::moment(double time) const {
    require_time(time);  // beyond it a double could not separate ticks
    // Compares the rounded result of time_of, so that the time of a tick belongs to that tick.
    const bool loops = ticks_per_loop > 0;
    const auto place = [&](double t) { return loops ? loop_fraction(t, loop_period) : t; };
    const double now = place(time);
    const double ticks = loops ? now * static_cast<double>(ticks_per_loop) : now / step;
    auto tick = static_cast<std::int64_t>(std::floor(ticks));
    const auto is_tick = [&](std::int64_t n) { return !loops || n < ticks_per_loop; };
    while (is_tick(tick + 1) && place(time_of(tick + 1)) <= now) ++tick;
    while (place(time_of(tick)) > now) --tick;
    return {tick, (now - place(time_of(tick))) * (loops ? loop_period : 1.0)};
}

std::int64_t FoamClock::before(std::int64_t tick, std::int64_t count) const {
    if (ticks_per_loop == 0) return tick - count;
    const std::int64_t remainder = (tick - count) % ticks_per_loop;
    return remainder < 0 ? remainder + ticks_per_loop : remainder;
}

std::int64_t FoamClock::ticks_between(std::int64_t from, std::int64_t to) const {
    return before(to, from);
}

std::int64_t preroll_ticks(const FoamClock& clock, std::int64_t tick,
                           const std::function<double(double time)>& lifetime) {
    // Foam of at most 1 must fall below 1/512 by m products of floats. Each product rounds twice,
    // the decay to a float and the result, by a factor of at most 1 + 2^-24: m ticks fade by at
    // least exp(-sum(step / lifetime - 2^-23)). 2^-23 is increased by 5 % for the sums in double.
    constexpr double kRounding = 1.25e-7;
    constexpr std::int64_t kMax = 1 << 20;  // 600 s by 0.01 s are 377106
    const std::int64_t most = clock.ticks_per_loop > 0 ? clock.ticks_per_loop : kMax;
    double left = std::log(512.0);
    std::int64_t count = 0;
    while (left > 0.0 && count < most) {
        const double seconds = lifetime(clock.time_of(clock.before(tick, count)));
        if (seconds <= 0.0) break;
        left -= clock.step / seconds - kRounding;
        ++count;
    }
    return count;
}

FoamState::FoamState(FoamClock clock, std::size_t samples, FoamStart start)
    : samples_(samples), follower_(clock, start) {}

FoamLayer FoamState::in_memory(const Follower::Layer& layer) const {
    FoamLayer result{.map = layer.map != nullptr ? layer.map->data() : nullptr,
                     .fade = layer.fade,
                     .cutoff = layer.cutoff};
    if (layer.kept != nullptr) {
        layer.kept->resize(samples_);
        result.kept = layer.kept->data();
    }
    return result;
}

FoamState::Follower::Source FoamState::source_in_memory(const FoamSource& source) const {
    return {source.lifetime,
            [&](double t, const Follower::Layer& before, PageVector<float>& foam) {
                foam.resize(samples_);
                source.tick(t, in_memory(before), foam);
            },
            source.progress};
}

FoamLayer FoamState::layer(double time, const FoamSource& source) {
    return in_memory(follower_.layer(time, source_in_memory(source)));
}

FoamLayer FoamState::layer_of_map(double time, const FoamSource& source) {
    return in_memory(follower_.layer_of_map(time, source_in_memory(source)));
}

}  // namespace ocean
