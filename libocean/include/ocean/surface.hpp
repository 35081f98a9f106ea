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
#include <span>
#include <vector>

#include "ocean/channel.hpp"
#include "ocean/domain.hpp"
#include "ocean/map_output.hpp"
#include "ocean/page_vector.hpp"

namespace ocean {

class ThreadPool;
struct Lattice;

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
