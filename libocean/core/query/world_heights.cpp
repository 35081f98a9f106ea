// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Heights by world position; see world_heights.hpp. A row of points at a time goes through the
// query.
#include "ocean/world_heights.hpp"

#include <vector>

namespace ocean {
namespace {

QueryOptions height_query(int resolution) {
    // Twice as fine where the library has such maps.
    return {.refine = 4 * resolution <= kMaxResolution ? 2 : 1,
            .foam = false,
            .resolution = resolution};
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
    std::vector<QuerySample> samples(n);
    for (std::size_t j = 0; j < n; ++j) {
        for (std::size_t i = 0; i < n; ++i) {
            row[i] = {static_cast<double>(i) * spacing, static_cast<double>(j) * spacing};
        }
        ocean.query(time, row, samples, height_query(resolution));
        for (std::size_t i = 0; i < n; ++i) {
            values[j * n + i] = static_cast<float>(samples[i].height);
            heights.folded += samples[i].folded ? 1 : 0;
        }
    }
    return heights;
}

std::uint64_t world_heights_bytes(const Sea& sea, int resolution) {
    if (sea.parameters.surface.choppiness == 0.0 && sea.take.empty()) return 0;
    return SurfaceQuery::map_bytes(sea.parameters.grid.resolution, height_query(resolution));
}

}  // namespace ocean
