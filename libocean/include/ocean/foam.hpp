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
#include <vector>

#include "ocean/foam_layer.hpp"
#include "ocean/modes.hpp"
#include "ocean/page_vector.hpp"

namespace ocean {

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

/// The foam's own clock: ticks n * step from t = 0, whatever the frame rate. In a loop the step is
/// foam_step rounded so that a loop is a whole number of ticks, and ticks are numbered within it.
struct FoamClock {
    double step = 0.05;               // s
    double loop_period = 0.0;         // s; 0 = no loop
    std::int64_t ticks_per_loop = 0;  // 0 = no loop

    /// The last tick at or before a time, and the seconds since it.
    struct Moment {
        std::int64_t tick;
        double since;
    };
    Moment moment(double time) const;
    double time_of(std::int64_t tick) const;
    /// How many ticks `to` is after `from`: in a loop 0 .. ticks_per_loop - 1.
    std::int64_t ticks_between(std::int64_t from, std::int64_t to) const;
    /// The tick `count` ticks before; count may be negative.
    std::int64_t before(std::int64_t tick, std::int64_t count) const;
};
FoamClock foam_clock(const SurfaceSettings& settings, double loop_period);

/// What foam is made of.
struct FoamSource {
    std::function<double(double time)> lifetime;  // s
    /// Writes the foam of a tick: W at that time with the layer of the tick before.
    std::function<void(double time, const FoamLayer& before, std::span<float> foam)> tick;
    /// May be empty. Called before each tick of a pre-roll; may throw to stop it, which leaves the
    /// state as it was.
    std::function<void(std::int64_t done, std::int64_t total)> progress;
};

/// Maps that following foam keeps: three ticks, and one in the making.
inline constexpr int kFoamMaps = 4;

enum class FoamStart {
    settled,  // from as far back as foam lives: the same bits as from any earlier start
    empty,    // from nothing, for live tools: right after settling_ticks()
};

/// How many ticks before `tick` foam must be followed from, to the same bits as from any earlier
/// start: ceil(ln(512) lifetime / step) and a little for the rounding of floats, at most one loop,
/// and where the lifetime changes, as many as make foam fade to 1/512.
std::int64_t preroll_ticks(const FoamClock& clock, std::int64_t tick,
                           const std::function<double(double time)>& lifetime);

/// The foam of a caller that steps: F_n = max(W_n, d F_(n-1)), d = exp(-step / lifetime), values
/// below 1/512 are 0. Pays only for ticks that it has not seen. The last three ticks are kept, so
/// that sub-frames may step back.
class FoamState {
  public:
    /// For maps of so many samples.
    FoamState(FoamClock clock, std::size_t samples, FoamStart start = FoamStart::settled);

    /// What there is of foam at a time, F_n exp(-(t - t_n) / lifetime) with n the last tick at or
    /// before it, for W(t) to be put over. Valid until the next call. What the source throws leaves
    /// a state that can go on.
    FoamLayer layer(double time, const FoamSource& source);
    /// Of ticks from that time on nothing is known any more: the sea has changed there.
    void forget_from(double time);
    /// How many ticks must still pass until a state that began empty shows all foam there is.
    std::int64_t settling_ticks() const { return settling_; }
    const FoamClock& clock() const { return clock_; }

  private:
    static constexpr std::size_t kKept = 3;  // the newest, and two that sub-frames step back to
    struct Tick {
        std::int64_t number;
        std::int64_t age;  // ticks since the state began
        PageVector<float> foam;
    };
    const Tick& reach(std::int64_t tick, const FoamSource& source);
    std::vector<Tick> begin(std::int64_t tick, std::int64_t preroll, const FoamSource& source);
    void step(std::vector<Tick>& kept, std::int64_t tick, const FoamSource& source,
              std::size_t keep = kKept);

    FoamClock clock_;
    std::size_t samples_;
    FoamStart start_;
    std::vector<Tick> kept_;   // the last ticks, the newest at the back
    PageVector<float> spare_;  // of a tick that is no longer kept, for the next
    std::int64_t settling_ = 0;
};

}  // namespace ocean
