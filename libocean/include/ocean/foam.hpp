// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Foam. Whitecaps are made where the shown surface is squeezed together: W = clamp((threshold - J)
// / foam_width, 0, 1) with its Jacobian J. Foam is what they leave: their running maximum on a
// clock of its own, fading with foam_lifetime. A pure function of the sea and the time.
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "ocean/foam_clock.hpp"
#include "ocean/foam_follower.hpp"
#include "ocean/foam_layer.hpp"
#include "ocean/modes.hpp"
#include "ocean/page_vector.hpp"

namespace ocean {

class ThreadPool;

/// Share of the sea that is white, 3.84e-6 U10^3.41, at most 1. [Monahan and O'Muircheartaigh
/// 1980].
double monahan_coverage(double wind_speed);

/// Ensemble mean of W, exact for the Gaussian gradients of linear waves.
double mean_whitecap(const GradientCovariance& covariance, double choppiness, double threshold,
                     double width);

/// Share of the surface, by label, that has folded over: P(J < 0), the mean of a W that jumps.
double folded_share(const GradientCovariance& covariance, double choppiness);

/// The Jacobian below which whitecaps begin. With FoamCoverage::monahan the one at which
/// mean_whitecap is monahan_coverage(wind_speed), but never above 1: water that is not squeezed
/// makes no whitecaps. Without wind, waves or choppiness: the lowest float, below every Jacobian,
/// so that W is exactly 0.
double whitecap_threshold(const GradientCovariance& covariance, const SurfaceSettings& settings,
                          double wind_speed);

/// What a map shows: `parameters` with the surface's settings as from with_threshold.
struct ShownSea {
    const DirectionalSpectrum& spectrum;
    const Parameters& parameters;
    int resolution;  // of the map
};

/// The lattice on which the foam of a map has its past. That of a finer map has four samples to its
/// shortest wave, since readers interpolate between them.
struct FoamLattice {
    int resolution;  // samples along a side, at most the map's
    int held_by;     // the past is of the waves that a map of this resolution holds

    auto operator<=>(const FoamLattice&) const = default;
};

/// Returns the foam lattice of a map: as fine as surface.foam_resolution says, or the grid, and
/// never finer than the map.
FoamLattice foam_lattice(const Parameters& parameters, int map_resolution);

/// Writes a lattice of foam onto a map of a power of two times as many samples along each side.
/// Between the lattice's samples foam^power is linear, so that the mean of foam^power, the cover,
/// is the lattice's.
void spread_foam(std::span<const float> lattice, double power, std::span<float> map,
                 ThreadPool& pool);

/// The waves that make a map's foam: those of the map make its whitecaps, those of the foam lattice
/// its past.
struct FoamWaves {
    GradientCovariance map;
    FoamLattice lattice;
    GradientCovariance past;
    double past_threshold;  // the Jacobian below which the past's whitecaps begin
};

/// Returns the waves of a map's foam. `parameters`: as the sea has them, without a threshold found.
FoamWaves foam_waves(const Modes& modes, const Parameters& parameters, int map_resolution);

/// Returns the power of foam that says how much of the water is covered: the ensemble mean of
/// foam^power is that of the whitecaps. 1 where foam leaves nothing behind. From labels that are
/// followed through some hundred times the foam's life, within about 1 %; the same for any number
/// of threads, and without a jump where the sea changes.
double cover_power(const ShownSea& sea, const FoamWaves& waves, ThreadPool& pool);

/// What foam in memory is made of.
struct FoamSource {
    std::function<double(double time)> lifetime;  // s
    /// Writes the foam of a tick: W at that time with the layer of the tick before.
    std::function<void(double time, const FoamLayer& before, std::span<float> foam)> tick;
    /// Of FoamFollower::Source.
    std::function<void(std::int64_t done, std::int64_t total)> progress;
};

/// Maps that following foam keeps: three ticks, and one in the making.
inline constexpr int kFoamMaps = 4;

/// FoamFollower of maps in memory.
class FoamState {
  public:
    /// For maps of so many samples.
    FoamState(FoamClock clock, std::size_t samples, FoamStart start = FoamStart::settled);

    FoamLayer layer(double time, const FoamSource& source);
    void forget_from(double time) { follower_.forget_from(time); }
    std::int64_t settling_ticks() const { return follower_.settling_ticks(); }
    const FoamClock& clock() const { return follower_.clock(); }

  private:
    using Follower = FoamFollower<PageVector<float>>;

    std::size_t samples_;
    Follower follower_;
};

}  // namespace ocean
