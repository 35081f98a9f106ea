// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Water velocity at a depth: the velocity maps of the surface, each mode faded to that depth.
#include <algorithm>
#include <cmath>
#include <optional>

#include "ocean/error.hpp"
#include "ocean/query.hpp"
#include "ocean/wave_sum.hpp"
#include "query/orbital_decay.hpp"
#include "query/query_points.hpp"
#include "query/spline_map.hpp"

namespace ocean {
namespace {

/// The modes with h0 multiplied by factor(k).
template <typename Factor>
Modes scaled(Modes modes, const Factor& factor) {
    for (CascadeModes& cascade : modes.cascades) {
        const int size = cascade.lattice.resolution;
        const double step = cascade.lattice.wavenumber_step();
        auto h0 = cascade.h0.begin();
        for (int j = 0; j < size; ++j) {
            for (int i = 0; i < size; ++i, ++h0) {
                if (*h0 == 0.0f) continue;
                const double k =
                    step * std::hypot(signed_wavenumber(i, size), signed_wavenumber(j, size));
                *h0 *= static_cast<float>(factor(k));
            }
        }
    }
    return modes;
}

SplineMap velocity_map(const Modes& modes, const Water& water, double time, double z, int fine,
                       ThreadPool& pool) {
    SurfaceSettings plain;
    plain.choppiness = 1.0;
    const auto map = [&](const auto& factor, ChannelSet channels) {
        return make_surface(scaled(modes, factor), plain, time, channels, Backend::cpu, pool, fine);
    };
    // The maps show the surface's own motion: what is left of it at z.
    const auto sideways = [&](double k) {
        return orbital_decay(k, z, water.depth).along / orbital_decay(k, 0.0, water.depth).along;
    };
    const auto upright = [&](double k) { return orbital_decay(k, z, water.depth).upright; };
    const Surface along = map(sideways, {Channel::vx, Channel::vy});
    const Surface up = map(upright, {Channel::vz});
    return SplineMap(
        {fine, modes.lattice.period},
        {along.channel(Channel::vx), along.channel(Channel::vy), up.channel(Channel::vz)}, pool);
}

}  // namespace

struct OrbitalVelocity::State {
    double period;
    std::optional<SplineMap> map;  // neither: below the bottom
    std::optional<WaveSum> exact;
    WaterLevel level;

    std::array<double, 3> sample(WorldPoint point) const {
        const double x = wrapped(point.x, period);
        const double y = wrapped(point.y, period);
        if (exact) {
            const WaterMotion motion = exact->water_motion(x, y, level);
            return {motion.velocity_x, motion.velocity_y, motion.velocity_z};
        }
        if (!map) return {};
        const SplineValue velocity = map->value(x, y);
        return {static_cast<double>(velocity.value[0]), static_cast<double>(velocity.value[1]),
                static_cast<double>(velocity.value[2])};
    }
};

OrbitalVelocity::OrbitalVelocity(const Modes& modes, const Water& water, double time, double z,
                                 const QueryOptions& options, ThreadPool& pool) {
    if (!std::isfinite(z)) {
        throw Error(ErrorKind::invalid_value, "z must be a finite number of metres");
    }
    require_finite_time(time);
    const int shown = shown_resolution(modes.lattice.resolution, options);
    const int fine = spline_resolution(modes.lattice.resolution, options);
    State state{modes.lattice.period, {}, {}, {}};
    z = std::min(z, 0.0);
    if (options.exact) {
        state.exact.emplace(modes, water, shown);
        state.exact->set_time(time);
        state.level = state.exact->water_level(z);
    } else if (z + water.depth >= 0.0) {
        state.map = velocity_map(spline_modes(modes, shown, fine), water, time, z, fine, pool);
    }
    state_ = std::make_unique<const State>(std::move(state));
}

OrbitalVelocity::~OrbitalVelocity() = default;
OrbitalVelocity::OrbitalVelocity(OrbitalVelocity&&) noexcept = default;
OrbitalVelocity& OrbitalVelocity::operator=(OrbitalVelocity&&) noexcept = default;

void OrbitalVelocity::sample(std::span<const WorldPoint> points,
                             std::span<std::array<double, 3>> velocities, ThreadPool& pool) const {
    require_finite(points);
    for_each_point(pool, points.size(), [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) velocities[i] = state_->sample(points[i]);
    });
}

std::uint64_t OrbitalVelocity::bytes(const Modes& modes, const QueryOptions& options) {
    if (options.exact) return WaveSum::bytes(modes, 2);
    return 2 * modes_bytes(grid_of(modes)) + spline_bytes(modes.lattice.resolution, options, 1);
}

std::array<double, 3> OrbitalVelocity::sample(WorldPoint point) const {
    require_finite({&point, 1});
    return state_->sample(point);
}

}  // namespace ocean
