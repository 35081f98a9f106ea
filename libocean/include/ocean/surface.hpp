// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The surface of one time: planar maps of N x N samples over one period, and the backends that
// compute them from the modes.
#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <string_view>
#include <vector>

#include "ocean/modes.hpp"
#include "ocean/page_vector.hpp"

namespace ocean {

class ThreadPool;

/// One scalar map. The order is that of the C API's enum.
enum class Channel : int {
    dx,  // offset of the displaced point, m: -choppiness * Dx
    dy,
    height,  // m
    nx,      // unit normal of the displaced surface
    ny,
    nz,
    slope_x,  // dh/dx by label, before displacement
    slope_y,
    jacobian,
    whitecap,
    foam,
    vx,  // d/dt of the displaced point at a fixed label, m/s
    vy,
    vz,
};
inline constexpr int kChannelCount = 14;

/// A set of channels; the fields users ask for by name are sets.
class ChannelSet {
  public:
    constexpr ChannelSet() = default;
    constexpr ChannelSet(std::initializer_list<Channel> channels) {
        for (Channel channel : channels) bits_ |= bit(channel);
    }
    constexpr bool contains(Channel channel) const { return (bits_ & bit(channel)) != 0; }
    constexpr ChannelSet operator|(ChannelSet other) const {
        ChannelSet result;
        result.bits_ = bits_ | other.bits_;
        return result;
    }
    constexpr ChannelSet without(Channel channel) const {
        ChannelSet result;
        result.bits_ = bits_ & ~bit(channel);
        return result;
    }
    constexpr bool intersects(ChannelSet other) const { return (bits_ & other.bits_) != 0; }
    constexpr bool empty() const { return bits_ == 0; }
    constexpr int size() const {
        int n = 0;
        for (std::uint32_t b = bits_; b != 0; b &= b - 1) ++n;
        return n;
    }

  private:
    static constexpr std::uint32_t bit(Channel channel) {
        return 1u << static_cast<unsigned>(channel);
    }
    std::uint32_t bits_ = 0;
};

/// A product with the name, channels and unit it has everywhere.
struct FieldInfo {
    std::string_view name;
    std::array<Channel, 3> channels;  // the first `count` hold
    int count;
    std::string_view unit;

    ChannelSet set() const;
};
/// height, displacement, slope, normal, jacobian, whitecap, foam, velocity.
std::span<const FieldInfo> field_table();
/// Throws Error invalid_value for an unknown name.
const FieldInfo& find_field(std::string_view name);

enum class Backend { cpu, gl, radix2, dft };
/// "cpu", "gl", "radix2", "dft"; throws Error. gl is not in this version.
Backend find_backend(std::string_view name);
std::string_view backend_name(Backend backend);

/// Fields that are sums over the modes. D is the horizontal displacement, rates are per second.
enum class Linear : int {
    height,
    displacement_x,
    displacement_y,
    slope_x,
    slope_y,
    gradient_xx,  // dDx/dx
    gradient_yy,
    gradient_xy,
    height_rate,
    displacement_x_rate,
    displacement_y_rate,
};
inline constexpr int kLinearCount = 11;

/// Planes of resolution^2 values, row-major [j][i]; empty where not asked for.
template <typename Real>
struct LinearPlanes {
    std::array<PageVector<Real>, kLinearCount> plane;
    const PageVector<Real>& operator[](Linear field) const {
        return plane[static_cast<std::size_t>(field)];
    }
    PageVector<Real>& operator[](Linear field) { return plane[static_cast<std::size_t>(field)]; }
};

/// Planar maps, row-major [j][i], sample (i, j) at (i, j) * period / resolution.
class Surface {
  public:
    Surface() = default;
    /// The maps are not filled: not with zeros either.
    Surface(Lattice lattice, double time, ChannelSet channels);

    int resolution() const { return lattice_.resolution; }
    double period() const { return lattice_.period; }
    double time() const { return time_; }
    bool has(Channel channel) const { return channels_.contains(channel); }
    ChannelSet channels() const { return channels_; }
    /// resolution^2 values; empty for a channel that was not asked for.
    std::span<const float> channel(Channel channel) const;
    std::span<float> channel(Channel channel);

  private:
    Lattice lattice_;
    double time_ = 0.0;
    ChannelSet channels_;
    std::array<PageVector<float>, kChannelCount> maps_;
};

/// settings with foam_threshold put to the Jacobian where whitecaps begin on a map of `resolution`
/// samples, and foam_coverage to FoamCoverage::threshold: found once for many surfaces.
SurfaceSettings with_threshold(const SurfaceSettings& settings, const Modes& modes, int resolution);

/// One map of `resolution` samples (0 = the modes' own; else a power of two, 32 .. 8192): all modes
/// below its Nyquist line, zero padded where the modes end. Any time, any order, any thread count:
/// the same bits. No foam: that has a past, see foam.hpp and Ocean.
Surface make_surface(const Modes& modes, const SurfaceSettings& settings, double time,
                     ChannelSet channels, Backend backend, ThreadPool& pool, int resolution = 0);

/// The small map of one cascade over its own period (modes.cascades[cascade].lattice), for hosts
/// that add up cascades while they draw: at any point the sum over the cascades, each wrapped round
/// its own period, is the sea's. `resolution` as for make_surface.
LinearPlanes<float> make_cascade_planes(const Modes& modes, std::size_t cascade, double time,
                                        std::span<const Linear> fields, Backend backend,
                                        ThreadPool& pool, int resolution = 0);
/// Whether any of the channels is made of that linear field. `flat`: the choppiness is 0, so that
/// no channel needs the gradients of the displacement.
bool is_made_of(ChannelSet channels, Linear field, bool flat = false);
/// The linear fields that the channels are made of.
std::vector<Linear> linear_fields(ChannelSet channels);
/// The channels from those planes. `settings` as from with_threshold.
Surface combine_planes(const LinearPlanes<float>& planes, const Lattice& lattice, double time,
                       const SurfaceSettings& settings, ChannelSet channels, ThreadPool& pool);

/// Largest |imaginary part| of the height field over its rms, by a full complex transform: 0 to
/// rounding when the modes are Hermitian. For tests and verification.
double imaginary_residue(const Modes& modes, double time);

}  // namespace ocean
