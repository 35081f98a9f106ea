// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Buffers of a host that maps are written into: planes, images of interleaved channels, vectors
// turned to other axes.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "ocean/channel.hpp"

namespace ocean {

/// What one component of an output holds: a channel, or one of the linear fields.
struct Quantity {
    int id = kNone;

    static constexpr int kNone = -1;
    static constexpr int kFirstLinear = 256;
    constexpr Quantity() = default;
    constexpr Quantity(Channel channel) : id(static_cast<int>(channel)) {}
    constexpr Quantity(Linear field) : id(kFirstLinear + static_cast<int>(field)) {}
    constexpr bool is_channel() const { return id != kNone && id < kFirstLinear; }
    constexpr bool is_linear() const { return id >= kFirstLinear; }
    constexpr Channel channel() const { return static_cast<Channel>(id); }
    constexpr Linear linear() const { return static_cast<Linear>(id - kFirstLinear); }
    constexpr bool operator==(const Quantity&) const = default;
};

/// resolution^2 samples of 1 to 4 components, interleaved, row-major [j][i]. A component without a
/// quantity is left as it is; the others are factor * quantity. With a seam there is one sample
/// more in each row and one row more: the first ones, a period on.
struct MapOutput {
    struct Component {
        Quantity quantity;
        float factor = 1.0f;
    };
    float* data = nullptr;
    int components = 1;
    std::array<Component, 4> component;
    std::size_t row_pitch = 0;  // floats from row to row; 0: no gaps
    bool seam = false;

    std::span<Component> used() { return std::span(component).first(count()); }
    std::span<const Component> used() const { return std::span(component).first(count()); }

    std::size_t width(int resolution) const {  // of a row, in floats
        return (static_cast<std::size_t>(resolution) + (seam ? 1 : 0)) * count();
    }
    std::size_t pitch(int resolution) const {
        return row_pitch > 0 ? row_pitch : width(resolution);
    }

  private:
    std::size_t count() const { return static_cast<std::size_t>(components); }
};

/// The channels among their quantities.
inline ChannelSet channels_of(std::span<const MapOutput> outputs) {
    ChannelSet channels;
    for (const MapOutput& output : outputs) {
        for (const auto& [quantity, factor] : output.used()) {
            if (quantity.is_channel()) channels = channels | quantity.channel();
        }
    }
    return channels;
}

/// The linear fields among their quantities.
inline LinearSet fields_of(std::span<const MapOutput> outputs) {
    LinearSet fields;
    for (const MapOutput& output : outputs) {
        for (const auto& [quantity, factor] : output.used()) {
            if (quantity.is_linear()) fields = fields | quantity.linear();
        }
    }
    return fields;
}

}  // namespace ocean
