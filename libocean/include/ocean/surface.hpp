// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The surface of one time: planar maps over a domain, which a backend makes from the modes. The
// domain of a sea is one period of N x N samples.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "ocean/backend.hpp"
#include "ocean/channel.hpp"
#include "ocean/domain.hpp"
#include "ocean/modes.hpp"
#include "ocean/page_vector.hpp"

namespace ocean {

class ThreadPool;

/// Planes of resolution^2 values, row-major [j][i]; those that were not requested are empty.
template <typename Real>
struct LinearPlanes {
    std::array<PageVector<Real>, kLinearCount> plane;
    const PageVector<Real>& operator[](Linear field) const {
        return plane[static_cast<std::size_t>(field)];
    }
    PageVector<Real>& operator[](Linear field) { return plane[static_cast<std::size_t>(field)]; }
};

/// Planar maps, row-major [j][i], sample (i, j) at domain().place(i, j).
class Surface {
  public:
    Surface() = default;
    /// Allocates the maps and leaves them uninitialised.
    Surface(const Domain& domain, double time, ChannelSet channels);
    /// Allocates maps over one period of a lattice.
    Surface(const Lattice& lattice, double time, ChannelSet channels)
        : Surface(Domain::tile(lattice.period, lattice.resolution), time, channels) {}

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

/// Writes the channels of a map of any domain into outputs without a seam, which hold no linear
/// fields.
void copy_channels(const Surface& map, std::span<const MapOutput> outputs, ThreadPool& pool);

/// Returns the settings with foam_threshold set to the Jacobian below which whitecaps begin on a
/// map of `resolution` samples, and foam_coverage set to FoamCoverage::threshold, so that the
/// threshold is computed once for many surfaces.
SurfaceSettings with_threshold(const SurfaceSettings& settings, const Modes& modes, int resolution);

/// Returns one map of `resolution` samples (0 = the modes' own; else a power of two, 32 .. 8192):
/// all modes below its Nyquist line, zero padded where the modes end. The bits do not depend on the
/// order of calls or the number of threads. Without foam, which has a past: see foam.hpp and Ocean.
Surface make_surface(const Modes& modes, const SurfaceSettings& settings, double time,
                     ChannelSet channels, const Backend& backend, ThreadPool& pool,
                     int resolution = 0);

/// Returns the channels computed from planes of their linear fields (fields_of), such as sums over
/// the small maps of cascades. `settings` as from with_threshold.
Surface combine_planes(const LinearPlanes<float>& planes, const Lattice& lattice, double time,
                       const SurfaceSettings& settings, ChannelSet channels, ThreadPool& pool);

/// Returns the largest |imaginary part| of the height field over its rms, by a full complex
/// transform: 0 to rounding if the modes are Hermitian. For tests and verification.
double imaginary_residue(const Modes& modes, double time);

}  // namespace ocean
