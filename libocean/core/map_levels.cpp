// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Maps of one time at halving resolutions; see map_levels.hpp.
#include "ocean/internal/map_levels.hpp"

#include <algorithm>

#include "ocean/error.hpp"
#include "ocean/internal/grid.hpp"

namespace ocean {

std::vector<Surface> map_levels(Ocean& ocean, double time, ChannelSet channels,
                                std::span<const int> resolutions) {
    // These have a past on each map; seen from far away they are their mean.
    constexpr Channel kAveraged[] = {Channel::foam, Channel::cover};
    const auto is_averaged = [&](const MapOutput& output) {
        return std::ranges::any_of(kAveraged, [&](Channel channel) {
            return output.component[0].quantity == Quantity(channel);
        });
    };
    std::vector<Surface> levels;
    for (const int resolution : resolutions) {
        if (levels.empty() || !channels.intersects({Channel::foam, Channel::cover})) {
            levels.push_back(ocean.evaluate(time, channels, resolution));
            continue;
        }
        Surface level(Lattice{resolution, levels.front().period()}, time, channels);
        std::vector<MapOutput> outputs = outputs_of(level);
        std::erase_if(outputs, is_averaged);
        ocean.evaluate_into(time, outputs, resolution);
        for (const Channel channel : kAveraged) {
            if (level.has(channel)) average_channel(channel, levels.back(), level);
        }
        levels.push_back(std::move(level));
    }
    return levels;
}

void average_channel(Channel channel, const Surface& fine, Surface& coarse) {
    const int n = coarse.resolution();
    if (fine.resolution() != 2 * n || !fine.has(channel) || !coarse.has(channel)) {
        throw Error(ErrorKind::invalid_value,
                    "foam and cover are averaged on a map of half the resolution");
    }
    const auto from = fine.channel(channel);
    const auto to = coarse.channel(channel);
    const auto row = [&](int j, int i) {
        const int wide = 2 * n;
        const auto at = [&](int k) {
            return from[static_cast<std::size_t>(((j + wide) % wide) * wide + (k + wide) % wide)];
        };
        return 0.5f * at(2 * i) + 0.25f * (at(2 * i - 1) + at(2 * i + 1));
    };
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) {
            to[static_cast<std::size_t>(j * n + i)] =
                0.5f * row(2 * j, i) + 0.25f * (row(2 * j - 1, i) + row(2 * j + 1, i));
        }
    }
}

}  // namespace ocean
