// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Foam. Whitecaps form where the displayed surface is compressed: W = clamp((threshold - J) /
// foam_width, 0, 1) with the surface's Jacobian J. Foam is the trace of the whitecaps: the running
// maximum of W on the foam's own clock, fading with foam_lifetime. A pure function of the sea and
// the time.
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "ocean/internal/foam_clock.hpp"
#include "ocean/internal/foam_follower.hpp"
#include "ocean/internal/foam_layer.hpp"
#include "ocean/internal/modes.hpp"
#include "ocean/page_vector.hpp"

namespace ocean {

class ThreadPool;

/// Returns the share of the sea that is white at a wind speed U10 [m/s]: 3.84e-6 U10^3.41, at most
/// 1 [Monahan and O'Muircheartaigh 1980].
double monahan_coverage(double wind_speed);

/// Returns the ensemble mean of W, exact for the Gaussian gradients of linear waves.
double mean_whitecap(const GradientCovariance& covariance, double choppiness, double threshold,
                     double width);

/// Returns the share of the surface, by label, that has folded over: P(J < 0), the mean of W in the
/// limit of width 0 at threshold 0.
double folded_share(const GradientCovariance& covariance, double choppiness);

/// Returns the Jacobian below which whitecaps begin. With FoamCoverage::threshold it is
/// settings.foam_threshold. With FoamCoverage::monahan it is the Jacobian at which mean_whitecap
/// equals monahan_coverage(wind_speed), but at most 1: water that is not compressed makes no
/// whitecaps. Without wind, waves or choppiness it is the lowest float, below every Jacobian, so
/// that W is exactly 0.
double whitecap_threshold(const GradientCovariance& covariance, const SurfaceSettings& settings,
                          double wind_speed);

/// Returns the settings with foam_threshold set to the Jacobian below which whitecaps begin on a
/// map of `resolution` samples, and foam_coverage set to FoamCoverage::threshold, so that the
/// threshold is computed once for many surfaces.
SurfaceSettings with_threshold(const SurfaceSettings& settings, const Modes& modes, int resolution);

/// The lattice on which the past of a map's foam is followed. A lattice under a finer map has four
/// samples per shortest wave, since readers interpolate between them.
struct FoamLattice {
    int resolution;  // samples along a side, at most the map's
    int held_by;     // resolution of a map that holds the waves of the past

    /// Returns true if maps finer than the lattice read this past.
    bool is_spread() const { return held_by < resolution; }
    auto operator<=>(const FoamLattice&) const = default;
};

/// Returns the foam lattice of a map: the map's own, or one of surface.foam_resolution if that is
/// coarser; 0 stands for grid.resolution where the sea has cascades, else for the map's own.
FoamLattice foam_lattice(const Parameters& parameters, int map_resolution);

/// Foam whose cover hosts show: a past, and over it the whitecaps of waves that a map of one
/// resolution holds.
struct ShownFoam {
    FoamLattice past;
    int whitecaps_held_by;

    /// Returns true if the whitecaps over the past are the same as the past's.
    bool is_past_alone() const { return whitecaps_held_by == past.held_by; }
    auto operator<=>(const ShownFoam&) const = default;
};

/// Returns the foam of a map; or of a lattice, without the whitecaps of a finer map over it.
ShownFoam foam_of_map(const Parameters& parameters, int map_resolution);
ShownFoam foam_of_lattice(const FoamLattice& lattice);

/// Returns the surface settings of a lattice, with the threshold of its whitecaps, as
/// with_threshold does for a map. With FoamCoverage::threshold, waves of a spread lattice make as
/// many whitecaps as all waves of the sea's default map do.
SurfaceSettings lattice_settings(const Modes& modes, const Parameters& parameters,
                                 const FoamLattice& lattice);

/// Writes a lattice of foam onto a map of a power of two times as many samples along each side.
/// Between the lattice's samples foam^power, the cover, is a cubic through them, held in [0, 1]:
/// its mean is the lattice's, but for the values so limited. A smoothing spline would lower the
/// crests of the cover, and whitecaps over it would add up to 5 % to its mean.
void spread_foam(std::span<const float> lattice, double power, std::span<float> map,
                 ThreadPool& pool);

/// The whitecaps of the waves that a map of one resolution holds.
struct Whitecaps {
    int held_by;                    // the resolution
    GradientCovariance covariance;  // of these waves
    double threshold;               // Jacobian below which whitecaps begin

    bool operator==(const Whitecaps&) const = default;
};

/// The whitecaps that make a map's foam: `past` leave the trace, `shown` lie over the trace. Both
/// are the same unless a coarser lattice is spread.
struct FoamWhitecaps {
    Whitecaps past;
    Whitecaps shown;
};

/// Returns the whitecaps of foam. `past`, `shown`: the settings, with the threshold of these
/// whitecaps.
FoamWhitecaps foam_whitecaps(const Modes& modes, const ShownFoam& foam, const SurfaceSettings& past,
                             const SurfaceSettings& shown);

/// Input for following foam at single labels. `parameters` are valid at the time of the foam.
struct FoamSea {
    const DirectionalSpectrum& spectrum;
    const Parameters& parameters;
};

/// Returns the exponent p of cover = foam^p: the ensemble means of foam^p and of the whitecaps are
/// equal. Returns 1 where foam leaves no trace. Computed from labels that are followed through some
/// hundred foam lifetimes; accurate to about 1 %, the same for any number of threads, and without a
/// jump where the sea changes.
double cover_power(const FoamSea& sea, const FoamWhitecaps& whitecaps, ThreadPool& pool);

/// Callbacks that make the foam maps of a FoamState.
struct FoamSource {
    std::function<double(double time)> lifetime;  // [s]
    /// Writes the foam of the tick at `time`: W over the layer of the tick before.
    std::function<void(double time, const FoamLayer& before, std::span<float> foam)> tick;
    /// Reports a pre-roll, see FoamFollower::Source::progress.
    std::function<void(std::int64_t done, std::int64_t total)> progress;
};

/// The number of maps that a FoamState keeps: three ticks, and one that is being computed.
inline constexpr int kFoamMaps = 4;

/// A FoamFollower whose maps lie in memory.
class FoamState {
  public:
    /// Begins without maps. `samples`: the size of each map.
    FoamState(FoamClock clock, std::size_t samples, FoamStart start = FoamStart::settled);

    /// Returns the earlier foam at a time [s], see FoamFollower::layer.
    FoamLayer layer(double time, const FoamSource& source);
    /// Returns the earlier foam for the map of a time [s], see FoamFollower::layer_of_map. After a
    /// map has written the layer's `kept`, keep() must be called.
    FoamLayer layer_of_map(double time, const FoamSource& source);
    void keep() { follower_.keep(); }
    void forget_from(double time) { follower_.forget_from(time); }
    std::int64_t settling_ticks() const { return follower_.settling_ticks(); }
    const FoamClock& clock() const { return follower_.clock(); }

  private:
    using Follower = FoamFollower<PageVector<float>>;

    Follower::Source source_in_memory(const FoamSource& source) const;
    FoamLayer in_memory(const Follower::Layer& layer) const;

    std::size_t samples_;
    Follower follower_;
};

}  // namespace ocean
