// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The exponent p of cover = foam^p, at which the mean of foam^p equals that of the whitecaps. Foam
// is the maximum over a past, so the mean of its powers has no closed form; it is measured by
// following the gradients of the displacement at single labels, tick by tick of the foam's clock.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "foam/foam_ages.hpp"
#include "foam/gradient_process.hpp"
#include "foam/jacobian_nodes.hpp"
#include "foam/label_windows.hpp"
#include "foam/layered_cover.hpp"
#include "foam/whitecap_gradients.hpp"
#include "ocean/foam.hpp"

namespace ocean {
namespace {

/// Follows labels through a whitecap in the middle of a window.
class Follower {
  public:
    /// Takes the settings of the displayed map. `aging`: of foam in a tick.
    Follower(const SurfaceSettings& shown, int reach, double aging)
        : shown_(shown), reach_(static_cast<std::size_t>(reach)), aging_(aging) {}

    /// Adds E[F^n] as the sum, over the ticks s of its last `reach`, of E[F^n / N; W(s) > 0], where
    /// N of them have W > 0: each whitecap counts for its share in the foam that follows.
    void follow(std::span<const Gradients> window, FollowedFoam& followed) {
        fresh_.clear();
        whitecaps_.clear();
        for (const Gradients& g : window) {
            const double whitecap = whitecap_of(g, shown_);
            whitecaps_.push_back(whitecap);
            fresh_.push_back(age_of(whitecap));
        }
        if (fresh_[reach_] == kNoFoam) return;  // by rounding alone
        // The waves' statistics are the same backwards in time.
        add(followed);
        std::ranges::reverse(fresh_);
        std::ranges::reverse(whitecaps_);
        add(followed);
    }

  private:
    void add(FollowedFoam& followed) const {
        double age = kNoFoam;
        int whitecaps = 0;
        for (std::size_t t = 0; t < fresh_.size(); ++t) {
            age = std::min(fresh_[t], age + aging_);
            whitecaps += fresh_[t] != kNoFoam ? 1 : 0;
            if (t < reach_) continue;
            followed.foam.add(age, 1.0 / whitecaps);
            followed.whitecap += whitecaps_[t] / whitecaps;
            whitecaps -= fresh_[t - reach_] != kNoFoam ? 1 : 0;
        }
    }

    const SurfaceSettings& shown_;
    std::size_t reach_;
    double aging_;
    std::vector<double> whitecaps_;
    std::vector<double> fresh_;  // the age of whitecaps as foam
};

}  // namespace

double FollowedFoam::power() const {
    constexpr double kMaxPower = 1e4;
    double low = 0.0, high = std::log(kMaxPower);
    if (foam.sum(1.0) <= whitecap) return 1.0;
    for (int i = 0; i < 40; ++i) {
        const double middle = 0.5 * (low + high);
        (foam.sum(std::exp(middle)) > whitecap ? low : high) = middle;
    }
    return std::exp(0.5 * (low + high));
}

double cover_power(const CoverPowerInput& sea, const FoamWaves& waves, ThreadPool& pool) {
    const SurfaceSettings& shown = sea.parameters.surface;
    const GradientCovariance& covariance = waves.map;
    const bool squeezed = shown.choppiness > 0.0 && covariance.aa + covariance.bb > 0.0;
    if (!squeezed || shown.foam_lifetime <= 0.0) return 1.0;
    const Stretch stretch =
        stretch_of(foam_clock(shown, sea.parameters.time.loop_period), shown.foam_lifetime);
    if (waves.lattice.held_by < sea.resolution && waves.past != waves.map) {
        return layered_cover_power(sea, waves, stretch, pool);
    }
    const GradientProcess process(sea, {sea.resolution}, covariance, principal_angle(covariance),
                                  stretch);
    const WhitecapGradients whitecaps(process.covariance(), shown.choppiness, shown.foam_threshold);
    if (!(whitecaps.share() > 0.0)) return 1.0;
    const double aging = stretch.step() / shown.foam_lifetime;
    const auto follow_draw = [&](int draw, FollowedFoam& followed) {
        const auto stretches = process.draw(static_cast<std::uint32_t>(draw));
        Follower follower(shown, stretch.reach, aging);
        std::vector<Gradients> window;
        for (int i = 0; i < kWindowsOfDraw; ++i) {
            const WindowPlace place = window_place(stretch, draw, i);
            process.passing(whitecaps.at(place.of_nodes, place.of_depth), place.tick, stretch.reach,
                            stretches[place.stretch], window);
            follower.follow(window, followed);
        }
    };
    return follow_draws(stretch, pool, follow_draw).power();
}

}  // namespace ocean
