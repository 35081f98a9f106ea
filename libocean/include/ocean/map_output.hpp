// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Buffers of a host that maps are written into: planes, images of interleaved channels, vectors
// turned to other axes.
#pragma once

#include <array>
#include <vector>

#include "ocean/surface.hpp"

namespace ocean {

/// What one component of an output holds: a channel, or one of the linear fields.
struct Quantity {
    int id = kNone;

    static constexpr int kNone = -1;
    constexpr Quantity() = default;
    constexpr Quantity(Channel channel) : id(static_cast<int>(channel)) {}
    constexpr Quantity(Linear field) : id(kChannelCount + static_cast<int>(field)) {}
    constexpr bool operator==(const Quantity&) const = default;
};

/// resolution^2 samples of 1 to 4 components, interleaved, row-major [j][i]. A component without a
/// quantity is left as it is; the others are factor * quantity.
struct MapOutput {
    struct Component {
        Quantity quantity;
        float factor = 1.0f;
    };
    float* data = nullptr;
    int components = 1;
    std::array<Component, 4> component;

    /// The channels among its quantities.
    ChannelSet channels() const {
        ChannelSet set;
        for (int c = 0; c < components; ++c) {
            const int id = component[static_cast<std::size_t>(c)].quantity.id;
            if (id >= 0 && id < kChannelCount) set = set | ChannelSet{static_cast<Channel>(id)};
        }
        return set;
    }
};

/// The planes of a surface as outputs: all of its channels.
std::vector<MapOutput> outputs_of(Surface& surface);

}  // namespace ocean
