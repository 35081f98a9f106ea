// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "coast/surface/shore_query.hpp"

#include <string>

#include "ocean/error.hpp"
#include "ocean/internal/cascades.hpp"
#include "waves/labels/label_search.hpp"
#include "waves/query/query_points.hpp"

namespace ocean {

void require_query_of_coast(const Grid& grid, const QueryOptions& options) {
    const int shown = default_map_resolution(grid);
    if (options.resolution != 0 && options.resolution != shown) {
        throw Error(ErrorKind::unsupported,
                    "resolution = " + std::to_string(options.resolution) +
                        ": over a bed (water.seabed) a query reads all waves of the grid; allowed: "
                        "0 or " +
                        std::to_string(shown));
    }
    spline_resolution(grid.resolution, {.refine = options.refine});
}

void query_shore(const ShoreSurface& surface, std::span<const WorldPoint> points,
                 std::span<QuerySample> samples, std::span<ShorePoint> labelled,
                 const ShoreSums* exact, ThreadPool& pool) {
    const auto read = [&](std::span<const WorldPoint> labels, std::span<ShorePoint> found) {
        surface.read(labels, JetParts::all, found, exact);
    };
    // A sum over all modes takes long enough to be a work item of its own.
    const std::size_t piece = exact != nullptr ? 1 : kSearchBlock;
    search_labels(read, surface.reach(), piece, points, samples, labelled, pool);
}

}  // namespace ocean
