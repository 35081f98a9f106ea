// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Water velocity at a depth: the velocity maps of the surface, each mode faded to that depth.
#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "ocean/error.hpp"
#include "ocean/query.hpp"
#include "ocean/wave_sum.hpp"
#include "query/orbital_decay.hpp"
#include "query/query_points.hpp"
#include "query/spline_map.hpp"
#include "query/spline_strips.hpp"

namespace ocean {
namespace {

/// What is left of each mode's own motion at the surface, by factor(k), on a spline.
template <typename Factor>
ModeFactor faded(const Modes& modes, int shown, int fine, const Factor& factor) {
    std::vector<double> steps;
    for (const CascadeModes& cascade : modes.cascades) {
        steps.push_back(cascade.lattice.wavenumber_step());
    }
    return [spline = spline_factor(modes, shown, fine), steps = std::move(steps), factor](
               std::size_t cascade, int n, int m) {
        const float on_spline = spline(cascade, n, m);
        if (on_spline == 0.0f || (n == 0 && m == 0)) return 0.0f;
        const double k = steps[cascade] * std::hypot(n, m);
        return static_cast<float>(static_cast<double>(on_spline) * factor(k));
    };
}

/// The three components at one depth. Along and upright motions fade differently: two transforms.
class VelocityStrips {
  public:
    VelocityStrips(const Modes& modes, const Water& water, double time, double z, int shown,
                   int fine, ThreadPool& pool)
        : map_({fine, modes.lattice.period}),
          along_(modes, fine, faded(modes, shown, fine, along(water, z)), pool),
          up_(modes, fine, faded(modes, shown, fine, upright(water, z)), pool) {
        const MapOutput sideways = map_.output({Channel::vx, Channel::vy, Quantity{}});
        const MapOutput upwards = map_.output({Quantity{}, Quantity{}, Channel::vz});
        along_.begin(modes, time, {&sideways, 1}, pool);
        up_.begin(modes, time, {&upwards, 1}, pool);
    }

    void prepare(std::span<const WorldPoint> points, ThreadPool* pool) const {
        PartSet strips(along_.count());
        for (const WorldPoint& point : points) {
            for (const int column : map_.columns(wrapped(point.x, map_.lattice().period))) {
                const int strip = along_.strip_of(column);
                if (!up_.has(strip)) strips.add(strip);
            }
        }
        if (strips.list().empty()) return;
        along_.make(strips.list(), pool);
        up_.make(strips.list(), pool);
    }
    SplineValue at(double x, double y) const { return map_.value(x, y); }

  private:
    using Decay = std::function<double(double k)>;
    static Decay along(const Water& water, double z) {
        return [z, depth = water.depth](double k) {
            return orbital_decay(k, z, depth).along / orbital_decay(k, 0.0, depth).along;
        };
    }
    static Decay upright(const Water& water, double z) {
        return [z, depth = water.depth](double k) { return orbital_decay(k, z, depth).upright; };
    }

    SplineMap map_;
    SplineStrips along_;
    SplineStrips up_;  // after along_: where it is there, both are
};

}  // namespace

struct OrbitalVelocity::State {
    double period;
    std::unique_ptr<VelocityStrips> map;  // neither: below the bottom
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
        const SplineValue velocity = map->at(x, y);
        return {static_cast<double>(velocity.value[0]), static_cast<double>(velocity.value[1]),
                static_cast<double>(velocity.value[2])};
    }
};

OrbitalVelocity::OrbitalVelocity(const Modes& modes, const Water& water, double time, double z,
                                 const QueryOptions& options, ThreadPool& pool) {
    if (!std::isfinite(z)) {
        throw Error(ErrorKind::invalid_value, "z must be a finite number of metres");
    }
    require_time(time);
    const int shown = shown_resolution(modes.lattice.resolution, options);
    const int fine = spline_resolution(modes.lattice.resolution, options);
    State state{modes.lattice.period, {}, {}, {}};
    z = std::min(z, 0.0);
    if (options.exact) {
        state.exact.emplace(modes, water, shown);
        state.exact->set_time(time);
        state.level = state.exact->water_level(z);
    } else if (z + water.depth >= 0.0) {
        state.map = std::make_unique<VelocityStrips>(modes, water, time, z, shown, fine, pool);
    }
    state_ = std::make_unique<const State>(std::move(state));
}

OrbitalVelocity::~OrbitalVelocity() = default;
OrbitalVelocity::OrbitalVelocity(OrbitalVelocity&&) noexcept = default;
OrbitalVelocity& OrbitalVelocity::operator=(OrbitalVelocity&&) noexcept = default;

void OrbitalVelocity::sample(std::span<const WorldPoint> points,
                             std::span<std::array<double, 3>> velocities, ThreadPool& pool) const {
    require_finite(points);
    if (state_->map) state_->map->prepare(points, &pool);
    for_each_point(pool, points.size(), state_->exact.has_value(),
                   [&](std::size_t first, std::size_t last) {
                       for (std::size_t i = first; i < last; ++i)
                           velocities[i] = state_->sample(points[i]);
                   });
}

std::uint64_t OrbitalVelocity::bytes(const Modes& modes, const QueryOptions& options) {
    if (options.exact) return WaveSum::bytes(modes, 2);
    // Two kernels, with packed modes each.
    return 2 * spline_bytes(modes.lattice.resolution, options, 1, 2);
}

std::array<double, 3> OrbitalVelocity::sample(WorldPoint point) const {
    require_finite({&point, 1});
    if (state_->map) state_->map->prepare({&point, 1}, nullptr);
    return state_->sample(point);
}

}  // namespace ocean
