// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The maps of one time; see surface.hpp.
#include "ocean/surface.hpp"

#include "ocean/thread_pool.hpp"

namespace ocean {

Surface::Surface(const Domain& domain, double time, ChannelSet channels)
    : domain_(domain), time_(time), channels_(channels) {
    for (std::size_t c = 0; c < maps_.size(); ++c) {
        if (has(static_cast<Channel>(c))) maps_[c].resize(domain.count());
    }
}

std::span<const float> Surface::channel(Channel channel) const {
    if (!has(channel)) return {};
    return maps_[static_cast<std::size_t>(channel)];
}

std::span<float> Surface::channel(Channel channel) {
    if (!has(channel)) return {};
    return maps_[static_cast<std::size_t>(channel)];
}

void copy_channels(const Surface& map, std::span<const MapOutput> outputs, ThreadPool& pool) {
    const int columns = map.domain().samples[0];
    const auto width = static_cast<std::size_t>(columns);
    pool.for_each_range(map.domain().samples[1], [&](int first, int last) {
        for (const MapOutput& output : outputs) {
            const auto used = output.used();
            for (std::size_t c = 0; c < used.size(); ++c) {
                if (!used[c].quantity.is_channel()) continue;
                const std::span<const float> from = map.channel(used[c].quantity.channel());
                for (int j = first; j < last; ++j) {
                    const auto row = static_cast<std::size_t>(j);
                    float* to = output.data + row * output.pitch(columns) + c;
                    for (std::size_t i = 0; i < width; ++i, to += used.size()) {
                        *to = used[c].factor * from[row * width + i];
                    }
                }
            }
        }
    });
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
