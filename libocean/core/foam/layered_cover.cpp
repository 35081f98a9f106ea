// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The cover's power where the whitecaps of all waves of a map are laid over a past that longer
// waves made: F(t) = max(W(t), max over s <= t of e^(-(t - s) / lifetime) V(s)), with V the
// whitecaps of the foam lattice. coverage_exponent.cpp is the case V = W.
#include <algorithm>
#include <cstddef>
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

/// Follows labels through a window whose middle has a whitecap of either kind.
///
/// Foam at t is made by the V(s) > 0 of the ticks s of its last `reach`, and by W(t) > 0. With N
/// how many of these there are, E[F^n(t)] is the sum of E[F^n / N; V(s) > 0] over s and of
/// E[F^n / N; W(t) > 0]: the first is what passing_past follows, the second what topped follows.
/// The same identity with W in place of F^n gives the mean of the whitecaps.
class LayeredFollower {
  public:
    /// `past`: the settings with V's threshold; `shown`: with W's. `aging`: the age that foam gains
    /// in a tick.
    LayeredFollower(const SurfaceSettings& past, const SurfaceSettings& shown, int reach,
                    double aging)
        : past_(past), shown_(shown), reach_(static_cast<std::size_t>(reach)), aging_(aging) {}

    /// Adds what follows a V > 0 in the middle of the window. `long_waves`: the gradients of the
    /// lattice's waves; those of the other waves begin at `first` of the periodic `short_waves`.
    void passing_past(std::span<const Gradients> long_waves, std::span<const Gradients> short_waves,
                      std::size_t first, double weight, FollowedFoam& followed) {
        read_past(long_waves);
        if (past_ages_[reach_] == kNoFoam) return;  // by rounding alone
        shown_whitecaps_.clear();
        for (std::size_t i = 0; i < long_waves.size(); ++i) {
            const Gradients& g = long_waves[i];
            const Gradients& h = short_waves[(first + i) % short_waves.size()];
            shown_whitecaps_.push_back(whitecap_of({g.a + h.a, g.b + h.b, g.c + h.c}, shown_));
        }
        // The waves' statistics are the same backwards in time.
        for (int direction = 0; direction < 2; ++direction) {
            add_all_that_follows(weight, followed);
            std::ranges::reverse(past_ages_);
            std::ranges::reverse(shown_whitecaps_);
        }
    }

    /// Adds the foam where W = `whitecap` > 0 in the middle of the window.
    void topped(std::span<const Gradients> long_waves, double whitecap, double weight,
                FollowedFoam& followed) {
        if (whitecap <= 0.0) return;  // by rounding alone
        read_past(long_waves);
        for (int direction = 0; direction < 2; ++direction) {
            double age = kNoFoam;
            int makers = 1;
            for (std::size_t t = 0; t <= reach_; ++t) {
                age = std::min(past_ages_[t], age + aging_);
                makers += past_ages_[t] != kNoFoam ? 1 : 0;
            }
            followed.foam.add(std::min(age, age_of(whitecap)), weight / makers);
            followed.whitecap += weight * whitecap / makers;
            std::ranges::reverse(past_ages_);
        }
    }

  private:
    void read_past(std::span<const Gradients> long_waves) {
        past_ages_.clear();
        for (const Gradients& g : long_waves) {
            past_ages_.push_back(age_of(whitecap_of(g, past_)));
        }
    }

    void add_all_that_follows(double weight, FollowedFoam& followed) const {
        double age = kNoFoam;
        int past_makers = 0;
        for (std::size_t t = 0; t < past_ages_.size(); ++t) {
            age = std::min(past_ages_[t], age + aging_);
            past_makers += past_ages_[t] != kNoFoam ? 1 : 0;
            if (t < reach_) continue;
            const double whitecap = shown_whitecaps_[t];
            const int makers = past_makers + (whitecap > 0.0 ? 1 : 0);
            followed.foam.add(std::min(age, age_of(whitecap)), weight / makers);
            followed.whitecap += weight * whitecap / makers;
            past_makers -= past_ages_[t - reach_] != kNoFoam ? 1 : 0;
        }
    }

    const SurfaceSettings& past_;
    const SurfaceSettings& shown_;
    std::size_t reach_;
    double aging_;
    std::vector<double> past_ages_;        // -ln V
    std::vector<double> shown_whitecaps_;  // W
};

GradientCovariance without(const GradientCovariance& all, const GradientCovariance& part) {
    GradientCovariance rest = part;
    rest *= -1.0;
    rest += all;
    return rest;
}

}  // namespace

double layered_cover_power(const CoverPowerInput& sea, const FoamWaves& waves,
                           const Stretch& stretch, ThreadPool& pool) {
    const SurfaceSettings& shown = sea.parameters.surface;
    const double angle = principal_angle(waves.past);
    const GradientProcess long_waves(sea, {waves.lattice.held_by}, waves.past, angle, stretch);
    const GradientProcess short_waves(sea, {sea.resolution, waves.lattice.held_by},
                                      without(waves.map, waves.past), angle, stretch);
    GradientCovariance all = long_waves.covariance();
    all += short_waves.covariance();
    const GradientFactors factors(all);
    SurfaceSettings past = shown;
    past.foam_threshold = waves.past_threshold;
    const WhitecapGradients past_whitecaps(long_waves.covariance(), past.choppiness,
                                           past.foam_threshold);
    const WhitecapGradients shown_whitecaps(all, shown.choppiness, shown.foam_threshold);
    if (!(past_whitecaps.share() > 0.0) || !(shown_whitecaps.share() > 0.0)) return 1.0;

    const double aging = stretch.step() / shown.foam_lifetime;
    const auto follow_draw = [&](int draw, FollowedFoam& followed) {
        const auto number = static_cast<std::uint32_t>(draw);
        const auto long_stretches = long_waves.draw(number);
        const auto short_stretches = short_waves.draw(number, 1);
        LayeredFollower follower(past, shown, stretch.reach, aging);
        std::vector<Gradients> window;
        for (int i = 0; i < kWindowsOfDraw; ++i) {
            const WindowPlace place = window_place(stretch, draw, i);
            const auto& drawn_long = long_stretches[place.stretch];
            const auto& drawn_short = short_stretches[place.stretch];
            long_waves.passing(past_whitecaps.at(place.of_nodes, place.of_depth), place.tick,
                               stretch.reach, drawn_long, window);
            const std::size_t ticks = drawn_short.size();
            const std::size_t first =
                (place.tick + ticks - static_cast<std::size_t>(stretch.reach)) % ticks;
            follower.passing_past(window, drawn_short, first, past_whitecaps.share(), followed);

            const Gradients at = shown_whitecaps.at(place.of_nodes, place.of_depth);
            const Gradients& g = drawn_long[place.tick];
            const Gradients& h = drawn_short[place.tick];
            const Gradients weights =
                weights_of(factors, {at.a - g.a - h.a, at.b - g.b - h.b, at.c - g.c - h.c});
            long_waves.shifted(weights, place.tick, stretch.reach, drawn_long, window);
            follower.topped(window, whitecap_of(at, shown), shown_whitecaps.share(), followed);
        }
    };
    return follow_draws(stretch, pool, follow_draw).power();
}

}  // namespace ocean
