// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The coast's queries at points: the surface over the bed and the water below it.
#include <algorithm>
#include <vector>

#include "coast.hpp"
#include "coast/surface/shore_query.hpp"
#include "waves/query/query_points.hpp"

namespace ocean {

void Coast::query(double time, std::span<const WorldPoint> points, std::span<QuerySample> samples,
                  const QueryOptions& options) {
    const Parameters& parameters = this->parameters();
    require_finite(points);
    require_query_of_coast(parameters.grid, options);
    if (points.empty()) return;
    std::vector<ShorePoint> found(points.size());
    if (options.exact) {
        const CoastChain::Exact exact = this->exact(time);
        query_shore(exact.surface, points, samples, found, &exact.sums, open().pool());
    } else {
        ShoreSurface& surface = this->surface(time, ShoreSurface::Rates::with);
        const auto [west, east] = std::ranges::minmax(points, {}, &WorldPoint::x);
        surface.prepare(open().modes(time), west.x - surface.reach(), east.x + surface.reach(),
                        open().pool());
        query_shore(surface, points, samples, found, nullptr, open().pool());
    }
    if (options.foam) add_foam(time, samples.first(points.size()), found);
}

double Coast::height_error(double time) {
    return surface(time, ShoreSurface::Rates::without).height_error();
}

void Coast::water_motion(double time, std::span<const WaterPoint> points,
                         std::span<WaterMotion> motions, const QueryOptions& options) {
    const Parameters& parameters = this->parameters();
    require_query_of_coast(parameters.grid, options);
    for_each_height(points, motions,
                    [&](double z, std::span<const WorldPoint> level, std::span<WaterMotion> found) {
                        const auto sample = [&](const ShoreSurface& surface,
                                                const ShoreSums* sums) {
                            motion_.sample(surface, open().modes(time), parameters.water, level, z,
                                           found, sums, open().pool());
                        };
                        if (options.exact) {
                            const CoastChain::Exact exact = this->exact(time);
                            sample(exact.surface, &exact.sums);
                        } else {
                            sample(surface(time, ShoreSurface::Rates::with), nullptr);
                        }
                    });
}

}  // namespace ocean
