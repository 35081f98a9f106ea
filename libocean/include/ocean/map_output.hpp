// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Buffers of a host that maps are written into: planes, images of interleaved channels, vectors in
// other axes.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "ocean/channel.hpp"

namespace ocean {

/// The content of one component of an output: a channel, one of the linear fields, or nothing.
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

/// resolution^2 samples of 1 to 4 interleaved components, row-major [j][i]. Each component receives
/// factor * quantity; a component without a quantity stays unchanged. With a seam each row has one
/// more sample and the map one more row: copies of the first sample and row, one period further.
struct MapOutput {
    struct Component {
        Quantity quantity;
        float factor = 1.0f;
    };
    float* data = nullptr;
    int components = 1;
    std::array<Component, 4> component;
    std::size_t row_pitch = 0;  // floats from row to row; 0 = width(resolution)
    bool seam = false;

    std::span<Component> used() { return std::span(component).first(count()); }
    std::span<const Component> used() const { return std::span(component).first(count()); }

    /// Returns the floats in a row.
    std::size_t width(int resolution) const {
        return (static_cast<std::size_t>(resolution) + (seam ? 1 : 0)) * count();
    }
    std::size_t pitch(int resolution) const {
        return row_pitch > 0 ? row_pitch : width(resolution);
    }

  private:
    std::size_t count() const { return static_cast<std::size_t>(components); }
};

/// Returns all channels among the quantities of the outputs.
inline ChannelSet channels_of(std::span<const MapOutput> outputs) {
    ChannelSet channels;
    for (const MapOutput& output : outputs) {
        for (const auto& [quantity, factor] : output.used()) {
            if (quantity.is_channel()) channels = channels | quantity.channel();
        }
    }
    return channels;
}

/// Returns all linear fields among the quantities of the outputs.
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
