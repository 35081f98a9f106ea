// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Heights by world position; see world_heights.hpp. A row of points at a time goes through the
// query.
#include "ocean/internal/world_heights.hpp"
#include "ocean/internal/surface_query.hpp"

#include <vector>

namespace ocean {
namespace {

QueryOptions height_query(int resolution) {
    // Twice as fine where the library has such maps.
    return {.refine = 4 * resolution <= kMaxResolution ? 2 : 1,
            .foam = false,
            .resolution = resolution};
}

/// Writes the heights of row j, which lies at `row`, and returns the number of folded samples.
std::size_t write_row(Ocean& ocean, double time, std::size_t j, std::span<const WorldPoint> row,
                      const QueryOptions& options, std::span<float> values) {
    std::vector<QuerySample> samples(row.size());
    ocean.query(time, row, samples, options);
    std::size_t folded = 0;
    for (std::size_t i = 0; i < row.size(); ++i) {
        values[j * row.size() + i] = static_cast<float>(samples[i].height);
        if (samples[i].folded) ++folded;
    }
    return folded;
}

}  // namespace

WorldHeights world_heights(Ocean& ocean, double time, int resolution) {
    const ChannelSet channels = {Channel::height};
    if (ocean.sea().at(time).surface.choppiness == 0.0) {
        return {ocean.evaluate(time, channels, resolution)};
    }
    const Lattice map{resolution, ocean.parameters().grid.patch_size};
    WorldHeights heights{Surface(map, time, channels)};
    const std::span<float> values = heights.surface.channel(Channel::height);
    const double spacing = map.period / resolution;
    const auto n = static_cast<std::size_t>(resolution);
    std::vector<WorldPoint> row(n);
    for (std::size_t j = 0; j < n; ++j) {
        for (std::size_t i = 0; i < n; ++i) {
            row[i] = {static_cast<double>(i) * spacing, static_cast<double>(j) * spacing};
        }
        heights.folded += write_row(ocean, time, j, row, height_query(resolution), values);
    }
    return heights;
}

WorldHeights region_heights(Ocean& ocean, double time, const Domain& domain) {
    WorldHeights heights{Surface(domain, time, {Channel::height})};
    const std::span<float> values = heights.surface.channel(Channel::height);
    std::vector<WorldPoint> row(static_cast<std::size_t>(domain.samples[0]));
    for (int j = 0; j < domain.samples[1]; ++j) {
        for (int i = 0; i < domain.samples[0]; ++i) {
            const auto [x, y] = domain.place(i, j);
            row[static_cast<std::size_t>(i)] = {x, y};
        }
        heights.folded +=
            write_row(ocean, time, static_cast<std::size_t>(j), row, {.foam = false}, values);
    }
    return heights;
}

std::uint64_t region_heights_bytes(const Domain& domain) {
    return static_cast<std::uint64_t>(domain.samples[0]) *
           (sizeof(WorldPoint) + sizeof(QuerySample));
}

std::uint64_t world_heights_bytes(const Sea& sea, int resolution) {
    if (sea.parameters.surface.choppiness == 0.0 && sea.take.empty()) return 0;
    return SurfaceQuery::map_bytes(sea.parameters.grid.resolution, height_query(resolution));
}

}  // namespace ocean
