// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "hulls/wake_motion.hpp"

#include <cstddef>
#include <optional>
#include <vector>

#include "hulls/wake.hpp"
#include "ocean/internal/surface_query.hpp"
#include "waves/query/query_points.hpp"

namespace ocean {

void add_wake_motion(const Wake& wake, const Water& water, bool exact,
                     std::span<const WaterPoint> points, std::span<WaterMotion> motions,
                     ThreadPool& pool) {
    std::vector<WaterPoint> below;  // those of the square, from its centre
    std::vector<std::size_t> at;
    const PathVector centre = wake.past().place.centre;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto [x, y, z] = points[i];
        if (!wake.holds(x, y)) continue;
        below.push_back({x - centre.x, y - centre.y, z});
        at.push_back(i);
    }
    std::vector<WaterMotion> found(below.size());
    const Modes waves = wake.modes();
    std::optional<OrbitalMotion> motion;
    for_each_height(
        below, found,
        [&](double z, std::span<const WorldPoint> level, std::span<WaterMotion> level_motions) {
            // The amplitudes of a wake have the phases of its time.
            if (motion) {
                motion->move_to(waves, water, 0.0, z, pool);
            } else {
                motion.emplace(waves, water, 0.0, z, QueryOptions{.exact = exact}, pool);
            }
            motion->sample(level, level_motions, pool);
        });
    for (std::size_t n = 0; n < at.size(); ++n) {
        const double share = wake.share_at(points[at[n]].x, points[at[n]].y);
        WaterMotion& sum = motions[at[n]];
        sum.velocity_x += share * found[n].velocity_x;
        sum.velocity_y += share * found[n].velocity_y;
        sum.velocity_z += share * found[n].velocity_z;
        sum.pressure += share * found[n].pressure;
    }
}

}  // namespace ocean
