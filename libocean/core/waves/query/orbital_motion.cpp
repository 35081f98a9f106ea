// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The motion of the water at a depth: maps as for the surface, with each mode decayed to that
// depth.
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "ocean/error.hpp"
#include "ocean/internal/surface_query.hpp"
#include "ocean/internal/wave_sum.hpp"
#include "ocean/query.hpp"
#include "waves/query/orbital_decay.hpp"
#include "waves/query/query_points.hpp"
#include "waves/query/spline_map.hpp"
#include "waves/query/spline_strips.hpp"

namespace ocean {
namespace {

/// Returns the factor scale(mode, k) for each mode that the spline shows, k > 0.
template <typename Scale>
ModeFactor faded(const Modes& modes, int shown, int fine, const Scale& scale) {
    return
        [spline = spline_factor(modes, shown, fine), &modes, scale](std::size_t c, int n, int m) {
            const float on_spline = spline(c, n, m).amplitude;
            if (on_spline == 0.0f || (n == 0 && m == 0)) return ModeScale{0.0f, 1.0f};
            const CascadeModes& cascade = modes.cascades[c];
            const double k =
                cascade.lattice.wavenumber_step() * std::sqrt(static_cast<double>(n * n + m * m));
            ModeScale result = scale(cascade, mode_index(n, m, cascade.lattice.resolution), k);
            result.amplitude *= on_spline;
            return result;
        };
}

/// A mode's potential is L dh/dt, L = cosh k(z+d) / (k sinh kd), and its pressure rho omega^2 L h;
/// see WaveSum::water_motion. If amplitudes are multiplied by omega^2 L / g and displacements D by
/// g / (omega^2 D), the height is pressure / (rho g), and the velocity of the displacement is the
/// water's along x and y.
auto along(const Modes& modes, const Water& water, double z) {
    return [rate_unit = modes.rate_unit(), &water, z](const CascadeModes& cascade, std::size_t at,
                                                      double k) {
        const double omega = kTwoPi * rate_unit *
                             (static_cast<double>(cascade.rate_high[at]) +
                              static_cast<double>(cascade.rate_low[at]));
        if (omega == 0.0) return ModeScale{0.0f, 1.0f};  // a wave that is left out
        const double fall = omega * omega / water.gravity;
        const double potential = orbital_decay(k, z, water.depth).along / k;
        return ModeScale{static_cast<float>(fall * potential),
                         1.0f / (static_cast<float>(fall) * cascade.displacement[at])};
    };
}

/// Returns the factor sinh k(z+d) / sinh kd of each mode, which turns the height's rate into the
/// water's upward velocity.
auto upright(const Water& water, double z) {
    return [&water, z](const CascadeModes&, std::size_t, double k) {
        return ModeScale{static_cast<float>(orbital_decay(k, z, water.depth).upright), 1.0f};
    };
}

/// One depth at one time. Motions along the wave and upright fade differently and need two
/// transforms.
class MotionStrips {
  public:
    MotionStrips(const Modes& modes, const Water& water, double z, int shown, int fine,
                 ThreadPool& pool)
        : map_({fine, modes.lattice.period}, pool),
          along_(modes, fine, faded(modes, shown, fine, along(modes, water, z)), pool),
          up_(modes, fine, faded(modes, shown, fine, upright(water, z)), pool) {}

    /// Packs other modes. Returns false if their lattice differs; the object is then unusable.
    bool repack(const Modes& modes, const Water& water, double z, int shown, ThreadPool& pool) {
        const int fine = map_.lattice().resolution;
        return map_.lattice().period == modes.lattice.period &&
               along_.repack(modes, faded(modes, shown, fine, along(modes, water, z)), pool) &&
               up_.repack(modes, faded(modes, shown, fine, upright(water, z)), pool);
    }
    void begin(const Modes& modes, double time, ThreadPool& pool) {
        using enum Channel;
        const MapOutput sideways = map_.output({vx, vy, height, height});
        const MapOutput upwards = map_.output({Quantity{}, Quantity{}, vz, Quantity{}});
        along_.begin(modes, time, {&sideways, 1}, pool);
        up_.begin(modes, time, {&upwards, 1}, pool);
    }

    void prepare(std::span<const WorldPoint> points, ThreadPool* pool) const {
        TileSet strips(along_.count());
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
    /// Returns vx, vy, vz, and pressure / (rho g).
    SplineValue at(double x, double y) const { return map_.value(x, y); }

  private:
    SplineMap map_;
    SplineStrips along_;
    SplineStrips up_;  // made last, because along_ writes over vz; its strips are ready in both
};

}  // namespace

struct OrbitalMotion::Impl {
    QueryOptions options;
    double period = 0.0;
    Water water;
    bool below_bottom = false;
    Revision revision;  // of the modes
    double z = 0.0;     // of the map [m]
    std::unique_ptr<MotionStrips> map;
    std::optional<WaveSum> exact;
    WaterLevel level;

    void move_to(const Modes& modes, const Water& now, double time, double asked_z,
                 ThreadPool& pool) {
        if (!std::isfinite(asked_z)) {
            throw Error(ErrorKind::invalid_value, "z must be a finite number of metres");
        }
        require_time(time);
        const double level_z = std::min(asked_z, 0.0);
        const bool same_modes = revision == modes.revision && water == now;
        const bool same_depth = same_modes && z == level_z;
        revision = {};  // invalid until the change is complete
        period = modes.lattice.period;
        water = now;
        z = level_z;
        below_bottom = z + water.depth < 0.0;
        const int shown = shown_resolution(modes.lattice.resolution, options);
        const int fine = spline_resolution(modes.lattice.resolution, options);
        if (options.exact) {
            if (!same_modes) exact.reset();
            if (!exact) exact.emplace(modes, water, shown);
            exact->set_time(time);
            level = exact->water_level(z);
        } else if (!below_bottom) {
            const bool there = map && (same_depth || map->repack(modes, water, z, shown, pool));
            if (!there) map = std::make_unique<MotionStrips>(modes, water, z, shown, fine, pool);
            map->begin(modes, time, pool);
        }
        revision = modes.revision;
    }

    WaterMotion sample(WorldPoint point) const {
        if (below_bottom) return {};
        const double x = wrapped(point.x, period);
        const double y = wrapped(point.y, period);
        if (exact) return exact->water_motion(x, y, level);
        const SplineValue at = map->at(x, y);
        return {static_cast<double>(at.value[0]), static_cast<double>(at.value[1]),
                static_cast<double>(at.value[2]),
                water.density * water.gravity * static_cast<double>(at.value[3])};
    }
    void prepare(std::span<const WorldPoint> points, ThreadPool* pool) const {
        if (map && !below_bottom) map->prepare(points, pool);
    }
};

OrbitalMotion::OrbitalMotion(const Modes& modes, const Water& water, double time, double z,
                             const QueryOptions& options, ThreadPool& pool)
    : impl_(std::make_unique<Impl>()) {
    impl_->options = options;
    impl_->move_to(modes, water, time, z, pool);
}

OrbitalMotion::~OrbitalMotion() = default;
OrbitalMotion::OrbitalMotion(OrbitalMotion&&) noexcept = default;
OrbitalMotion& OrbitalMotion::operator=(OrbitalMotion&&) noexcept = default;

void OrbitalMotion::move_to(const Modes& modes, const Water& water, double time, double z,
                            ThreadPool& pool) {
    impl_->move_to(modes, water, time, z, pool);
}

void OrbitalMotion::sample(std::span<const WorldPoint> points, std::span<WaterMotion> motions,
                           ThreadPool& pool) const {
    require_finite(points);
    impl_->prepare(points, &pool);
    for_each_point(pool, points.size(), impl_->exact.has_value(),
                   [&](std::size_t first, std::size_t last) {
                       for (std::size_t i = first; i < last; ++i)
                           motions[i] = impl_->sample(points[i]);
                   });
}

std::uint64_t OrbitalMotion::bytes(const Modes& modes, const QueryOptions& options) {
    if (options.exact) return WaveSum::bytes(modes, 2);
    // Two kernels, each with its packed modes.
    return 2 * spline_bytes(modes.lattice.resolution, options, 1, 2);
}

WaterMotion OrbitalMotion::sample(WorldPoint point) const {
    require_finite({&point, 1});
    impl_->prepare({&point, 1}, nullptr);
    return impl_->sample(point);
}

}  // namespace ocean
