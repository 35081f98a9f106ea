// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Maps of one time at halving resolutions; see map_levels.hpp.
#include "ocean/map_levels.hpp"

#include "ocean/error.hpp"

namespace ocean {

std::vector<Surface> map_levels(Ocean& ocean, double time, ChannelSet channels,
                                std::span<const int> resolutions) {
    std::vector<Surface> levels;
    for (const int resolution : resolutions) {
        if (levels.empty() || !channels.contains(Channel::foam)) {
            levels.push_back(ocean.evaluate(time, channels, resolution));
            continue;
        }
        // Foam has a past on each map; what it looks like from far away is its mean.
        Surface level(Lattice{resolution, levels.front().period()}, time, channels);
        std::vector<MapOutput> outputs = outputs_of(level);
        std::erase_if(outputs, [](const MapOutput& output) {
            return output.component[0].quantity == Quantity(Channel::foam);
        });
        ocean.evaluate_into(time, outputs, resolution);
        average_foam(levels.back(), level);
        levels.push_back(std::move(level));
    }
    return levels;
}

void average_foam(const Surface& fine, Surface& coarse) {
    const int n = coarse.resolution();
    if (fine.resolution() != 2 * n || !fine.has(Channel::foam) || !coarse.has(Channel::foam)) {
        throw Error(ErrorKind::invalid_value, "foam is averaged on a map of half the resolution");
    }
    const auto from = fine.channel(Channel::foam);
    const auto to = coarse.channel(Channel::foam);
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
