// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The surface of one time: planar maps over a domain, or buffers of a host that maps are written
// into. The domain of a sea is one period of N x N samples.
//
//     const Surface surface = ocean.evaluate(12.0, {Channel::height, Channel::foam});
//     std::span<const float> height = surface.channel(Channel::height);
//     const int n = surface.resolution();
//     const float z = height[20 * n + 10];  // [m], at surface.domain().place(10, 20)
//
//     MapOutput image{.data = rgba, .components = 4};  // or into a host's own buffer
//     image.component = {{{Channel::nx}, {Channel::ny}, {Channel::nz}, {Channel::foam}}};
//     ocean.evaluate_into(12.0, {&image, 1}, n);
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "ocean/channel.hpp"
#include "ocean/domain.hpp"
#include "ocean/page_vector.hpp"

namespace ocean {

class ThreadPool;
struct Lattice;

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

/// Planar maps, row-major [j][i], sample (i, j) at domain().place(i, j).
class Surface {
  public:
    Surface() = default;
    /// Allocates the maps and leaves them uninitialised.
    Surface(const Domain& domain, double time, ChannelSet channels);
    /// Allocates maps over one period of a lattice.
    Surface(const Lattice& lattice, double time, ChannelSet channels);

    const Domain& domain() const { return domain_; }
    /// Returns the samples along x; a tile has as many along y.
    int resolution() const { return domain_.samples[0]; }
    /// Returns the size along x [m]: the period of a tile.
    double period() const { return domain_.size[0]; }
    double time() const { return time_; }
    bool has(Channel channel) const { return channels_.contains(channel); }
    ChannelSet channels() const { return channels_; }
    /// Returns a value for each sample of the domain; empty for a channel that was not requested.
    std::span<const float> channel(Channel channel) const;
    std::span<float> channel(Channel channel);

  private:
    Domain domain_;
    double time_ = 0.0;
    ChannelSet channels_;
    std::array<PageVector<float>, kChannelNumbers> maps_;
};

/// Returns an output for each channel of a surface, which writes into its planes.
std::vector<MapOutput> outputs_of(Surface& surface);

}  // namespace ocean
