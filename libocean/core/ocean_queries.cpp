// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The facade's queries at points: the surface, the water below it, floating bodies. The last query
// of each kind is kept for the next one of the same time.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "chain.hpp"
#include "coast/surface/shore_motion.hpp"
#include "coast/surface/shore_query.hpp"
#include "coast/surface/shore_surface.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/memory.hpp"
#include "ocean/ocean.hpp"
#include "ocean/surface_query.hpp"
#include "ocean_coast.hpp"
#include "waves/query/query_bounds.hpp"

namespace ocean {
namespace {

void require_query_memory(std::uint64_t bytes) {
    require_memory(bytes, "a query of this sea");
}

}  // namespace

QueryOptions Ocean::shown(QueryOptions options) const {
    if (options.resolution == 0) {
        options.resolution = default_map_resolution(sea_.parameters.grid);
    }
    return options;
}

const SurfaceQuery& Ocean::surface_query(double time, const QueryOptions& options) {
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

const OrbitalMotion& Ocean::orbital_motion(double time, double z, const QueryOptions& options) {
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

void Ocean::query(double time, std::span<const WorldPoint> points, std::span<QuerySample> samples,
                  const QueryOptions& options) {
    if (sea_.parameters.water.bed) return query_shore(time, points, samples, options);
    surface_query(time, options).sample(points, samples, pool_);
}

double Ocean::query_height_error(double time, const QueryOptions& options) {
    if (sea_.parameters.water.bed) {
        if (!options.exact) return shore_surface(time, false).height_error();
        const int map = default_map_resolution(sea_.parameters.grid);
        return query_bounds(modes(time), map, map, true, pool_).error;
    }
    return surface_query(time, options).height_error();
}

void Ocean::water_motion(double time, std::span<const WaterPoint> points,
                         std::span<WaterMotion> motions, const QueryOptions& options) {
    if (sea_.parameters.water.bed) require_query_of_coast(sea_.parameters.grid, options);
    for (const WaterPoint& point : points) {
        if (std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z)) continue;
        throw Error(ErrorKind::invalid_value,
                    "the coordinates of a point must be finite numbers of metres");
    }
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return points[i].z; });
    std::vector<WorldPoint> level;
    std::vector<WaterMotion> found;
    for (std::size_t first = 0, last = 0; first < order.size(); first = last) {
        const double z = points[order[first]].z;
        level.clear();
        for (; last < order.size() && points[order[last]].z == z; ++last) {
            level.push_back({points[order[last]].x, points[order[last]].y});
        }
        found.resize(level.size());
        if (sea_.parameters.water.bed) {
            if (!shore_motion_) shore_motion_ = std::make_unique<ShoreMotion>();
            if (options.exact) {
                with_coast_sea(time, [&](const CoastSea& sea) {
                    const Coast::Exact exact =
                        coast_->exact(sea, time, pool_, options_.build_progress);
                    shore_motion_->sample(exact.surface, sea.modes, now().water, level, z, found,
                                          &exact.sums, pool_);
                });
            } else {
                const ShoreSurface& surface = shore_surface(time, true);
                shore_motion_->sample(surface, current_modes(), now().water, level, z, found,
                                      nullptr, pool_);
            }
        } else {
            orbital_motion(time, z, options).sample(level, found, pool_);
        }
        for (std::size_t i = first; i < last; ++i) motions[order[i]] = found[i - first];
    }
}

void Ocean::float_poses(double time, std::span<const FloatBody> bodies,
                        std::span<FloatPose> poses) {
    if (sea_.parameters.water.bed) {
        const Grid& grid = sea_.parameters.grid;
        const double spacing = grid.patch_size / default_map_resolution(grid);
        const SampleSurface surface = [&](std::span<const WorldPoint> points,
                                          std::span<QuerySample> samples) {
            query_shore(time, points, samples, {.foam = false});
        };
        std::vector<FloatPose> found;
        for (const FloatBody& body : bodies) found.push_back(float_pose(surface, spacing, body));
        std::ranges::copy(found, poses.begin());
        return;
    }
    // A pose needs no foam, but the query that is kept may have some.
    QueryOptions options;
    options.foam =
        surface_query_ && surface_query_->key == QueryKey{revision_, time, 0.0, shown({})};
    const SurfaceQuery& query = surface_query(time, options);
    std::vector<FloatPose> found;
    for (const FloatBody& body : bodies) found.push_back(float_pose(query, body, pool_));
    std::copy(found.begin(), found.end(), poses.begin());
}

}  // namespace ocean
