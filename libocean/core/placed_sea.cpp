// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "placed_sea.hpp"

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "ocean/error.hpp"
#include "ocean/internal/cascades.hpp"
#include "ocean/internal/memory.hpp"
#include "ocean/land_mask.hpp"
#include "waves/labels/region_rows.hpp"
#include "waves/query/query_bounds.hpp"

namespace ocean {

int PlacedSea::shown() const {
    return default_map_resolution(parameters().grid);
}

Surface PlacedSea::open_map(double time, ChannelSet channels) {
    Surface map(Lattice{shown(), parameters().grid.patch_size}, time, channels);
    open_.evaluate_into(time, outputs_of(map), shown());
    return map;
}

void PlacedSea::require_masks(ChannelSet channels) const {
    std::string own;
    for (const Product& mask : kMaskProducts) {
        if (masks().contains(mask.set())) own += (own.empty() ? "" : ", ") + std::string(mask.name);
    }
    for (const Product& mask : kMaskProducts) {
        if (!channels.intersects(mask.set()) || masks().contains(mask.set())) continue;
        throw Error(ErrorKind::unsupported, std::string(name()) + " has no " +
                                                std::string(mask.name) + "; its masks: " + own);
    }
}

void PlacedSea::begin_region(double time, const Domain& domain, ChannelSet channels,
                             std::size_t new_maps) {
    require_time(time);
    require_region(domain);
    open_.parameters_at(time);  // throws if the sea is not valid
    require_masks(channels);
    const RegionMaps needed = region_maps(channels);
    const auto maps = static_cast<std::uint64_t>(new_maps + needed.maps);
    const std::uint64_t points = needed.labels ? sizeof(WorldPoint) : 0;
    require_memory(domain.count() * (maps * sizeof(float) + points),
                   "a region of " + std::to_string(domain.samples[0]) + " x " +
                       std::to_string(domain.samples[1]) + " samples");
}

Surface PlacedSea::region(double time, const Domain& domain, ChannelSet channels) {
    begin_region(time, domain, channels, static_cast<std::size_t>(channels.size()));
    Surface map(domain, time, channels);
    write_region(time, domain, outputs_of(map));
    return map;
}

void PlacedSea::region_into(double time, const Domain& domain, std::span<const MapOutput> outputs) {
    if (!fields_of(outputs).empty()) {
        throw Error(ErrorKind::unsupported,
                    "a region has no linear fields: " + std::string(why_no_linear_fields()));
    }
    begin_region(time, domain, channels_of(outputs), 0);
    write_region(time, domain, outputs);
}

double PlacedSea::query_height_error(double time, const QueryOptions& options) {
    if (!options.exact) return height_error(time);
    return query_bounds(open_.modes(time), shown(), shown(), true, open_.pool()).error;
}

void PlacedSea::float_poses(double time, std::span<const FloatBody> bodies,
                            std::span<FloatPose> poses) {
    const double spacing = parameters().grid.patch_size / shown();
    const SampleSurface surface = [&](std::span<const WorldPoint> points,
                                      std::span<QuerySample> samples) {
        query(time, points, samples, {.foam = false});
    };
    std::vector<FloatPose> found;
    for (const FloatBody& body : bodies) found.push_back(float_pose(surface, spacing, body));
    std::ranges::copy(found, poses.begin());
}

}  // namespace ocean
