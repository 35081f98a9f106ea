// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "coast/surface/shore_motion.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "ocean/thread_pool.hpp"
#include "waves/query/orbital_decay.hpp"

namespace ocean {
namespace {

WaterMotion mixed(const WaterMotion& a, double of_a, const WaterMotion& b, double of_b) {
    return {of_a * a.velocity_x + of_b * b.velocity_x, of_a * a.velocity_y + of_b * b.velocity_y,
            of_a * a.velocity_z + of_b * b.velocity_z, of_a * a.pressure + of_b * b.pressure};
}

/// Returns the sum of the waves at one place, each as a linear wave over the local depth: the
/// horizontal velocity of a wave of amplitude a is omega a cosh k(z + d) / sinh kd in its crest.
/// [Dean and Dalrymple 1991] section 4.2.
WaterMotion motion_of(std::span<const LocalWave> waves, double z, double depth,
                      const Water& water) {
    WaterMotion sum{};
    z = std::min(z, 0.0);
    if (z <= -depth) return sum;
    for (const LocalWave& wave : waves) {
        const OrbitalDecay decay = orbital_decay(wave.wavenumber, z, depth);
        // -d/dt of the displacement: decay.along is cosh k(z + d) / sinh kd.
        const double along = -static_cast<double>(wave.imaginary.by_t()) * decay.along;
        sum.velocity_x += along * std::cos(wave.direction);
        sum.velocity_y += along * std::sin(wave.direction);
        sum.velocity_z += static_cast<double>(wave.real.by_t()) * decay.upright;
        // rho omega^2 / k L a, with omega^2 = g k tanh kd.
        sum.pressure += water.density * water.gravity *
                        std::tanh(std::min(wave.wavenumber * depth, 30.0)) *
                        static_cast<double>(wave.real.value()) * decay.along;
    }
    return sum;
}

/// Moves a motion to these modes and this time, or makes it.
OrbitalMotion& moved(std::optional<OrbitalMotion>& motion, const Modes& modes, const Water& water,
                     double time, double z, bool exact, ThreadPool& pool) {
    if (motion) {
        motion->move_to(modes, water, time, z, pool);
    } else {
        motion.emplace(modes, water, time, z, QueryOptions{.exact = exact}, pool);
    }
    return *motion;
}

}  // namespace

void ShoreMotion::sample(const ShoreSurface& surface, const Modes& modes, const Water& water,
                         std::span<const WorldPoint> places, double z,
                         std::span<WaterMotion> motions, const ShoreSums* exact, ThreadPool& pool) {
    const bool is_exact = exact != nullptr;
    if (is_exact != is_exact_) {
        open_.reset();
        remainder_.reset();
    }
    is_exact_ = is_exact;
    const double time = is_exact ? exact->time : surface.time();
    std::vector<WaterMotion> open(places.size());
    std::vector<WaterMotion> unbanded(places.size());
    moved(open_, modes, water, time, z, is_exact, pool).sample(places, open, pool);
    moved(remainder_, surface.remainder_modes(), water, time, z, is_exact, pool)
        .sample(places, unbanded, pool);
    std::vector<LocalWave> waves;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const LocalSea local = surface.local_sea(places[i], waves, exact);
        const WaterMotion coast = mixed(motion_of(waves, z, local.depth, water), local.limited,
                                        unbanded[i], local.short_wave_gain);
        const WaterMotion influenced =
            mixed(coast, local.bed_influence, open[i], 1.0 - local.bed_influence);
        motions[i] = mixed(influenced, local.coast, open[i], local.open);
        if (local.is_over_bed && z <= local.bed) motions[i] = {};
    }
}

}  // namespace ocean
