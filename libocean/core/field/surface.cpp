// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The maps of one time; see surface.hpp.
#include "ocean/surface.hpp"

#include "ocean/internal/grid.hpp"

namespace ocean {

Surface::Surface(const Domain& domain, double time, ChannelSet channels)
    : domain_(domain), time_(time), channels_(channels) {
    for (std::size_t c = 0; c < maps_.size(); ++c) {
        if (has(static_cast<Channel>(c))) maps_[c].resize(domain.count());
    }
}

Surface::Surface(const Lattice& lattice, double time, ChannelSet channels)
    : Surface(Domain::tile(lattice.period, lattice.resolution), time, channels) {}

std::span<const float> Surface::channel(Channel channel) const {
    if (!has(channel)) return {};
    return maps_[static_cast<std::size_t>(channel)];
}

std::span<float> Surface::channel(Channel channel) {
    if (!has(channel)) return {};
    return maps_[static_cast<std::size_t>(channel)];
}

std::vector<MapOutput> outputs_of(Surface& surface) {
    std::vector<MapOutput> outputs;
    for (int c = 0; c < kChannelNumbers; ++c) {
        const auto channel = static_cast<Channel>(c);
        if (!surface.has(channel)) continue;
        outputs.push_back({surface.channel(channel).data(), 1, {{{channel, 1.0f}}}});
    }
    return outputs;
}

}  // namespace ocean
