// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The open sea's queries at points: the surface, the water below it, floating bodies. The last
// query of each kind is kept for the next one of the same time.
#include <algorithm>
#include <utility>
#include <vector>

#include "ocean/internal/memory.hpp"
#include "ocean/internal/open_sea.hpp"
#include "ocean/internal/surface_query.hpp"
#include "waves/query/query_points.hpp"

namespace ocean {
namespace {

void require_query_memory(std::uint64_t bytes) {
    require_memory(bytes, "a query of this sea");
}

}  // namespace

QueryOptions OpenSea::shown(QueryOptions options) const {
    if (options.resolution == 0) {
        options.resolution = default_map_resolution(sea_.parameters.grid);
    }
    return options;
}

const SurfaceQuery& OpenSea::surface_query(double time, const QueryOptions& options) {
    const QueryKey key{revision_, time, 0.0, shown(options)};
    auto& kept = surface_query_;
    if (kept && kept->key == key) return kept->query;
    if (kept && kept->key.options != key.options) kept.reset();
    FoamMap foam;
    if (options.foam) {
        const Surface map = evaluate(time, {Channel::foam}, key.options.resolution);
        const std::span<const float> values = map.channel(Channel::foam);
        foam = {{values.begin(), values.end()}, map.resolution()};
    }
    const Modes& modes = this->modes(time);  // foam has been in the past
    if (kept) {
        kept->key.revision = 0;
        kept->query.move_to(modes, now().surface, now().water, time, pool_, std::move(foam));
        kept->key = key;
    } else {
        require_query_memory(SurfaceQuery::bytes(modes, key.options));
        kept = {key, SurfaceQuery(modes, now().surface, now().water, time, key.options, pool_,
                                  std::move(foam))};
    }
    return kept->query;
}

const OrbitalMotion& OpenSea::orbital_motion(double time, double z, const QueryOptions& options) {
    const QueryKey key{revision_, time, z, shown(options)};
    auto& kept = orbital_motion_;
    if (kept && kept->key == key) return kept->query;
    if (kept && kept->key.options != key.options) kept.reset();
    const Modes& modes = this->modes(time);
    if (kept) {
        kept->key.revision = 0;
        kept->query.move_to(modes, now().water, time, z, pool_);
        kept->key = key;
    } else {
        require_query_memory(OrbitalMotion::bytes(modes, key.options));
        kept = {key, OrbitalMotion(modes, now().water, time, z, key.options, pool_)};
    }
    return kept->query;
}

void OpenSea::query(double time, std::span<const WorldPoint> points, std::span<QuerySample> samples,
                    const QueryOptions& options) {
    surface_query(time, options).sample(points, samples, pool_);
}

double OpenSea::query_height_error(double time, const QueryOptions& options) {
    return surface_query(time, options).height_error();
}

void OpenSea::water_motion(double time, std::span<const WaterPoint> points,
                           std::span<WaterMotion> motions, const QueryOptions& options) {
    for_each_height(points, motions,
                    [&](double z, std::span<const WorldPoint> level, std::span<WaterMotion> found) {
                        orbital_motion(time, z, options).sample(level, found, pool_);
                    });
}

void OpenSea::float_poses(double time, std::span<const FloatBody> bodies,
                          std::span<FloatPose> poses) {
    // A pose needs no foam, but the query that is kept may have some.
    QueryOptions options;
    options.foam =
        surface_query_ && surface_query_->key == QueryKey{revision_, time, 0.0, shown({})};
    const SurfaceQuery& query = surface_query(time, options);
    std::vector<FloatPose> found;
    for (const FloatBody& body : bodies) found.push_back(float_pose(query, body, pool_));
    std::ranges::copy(found, poses.begin());
}

}  // namespace ocean
