// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The exponent p of cover = foam^p, at which the means of foam^p and of the whitecaps are equal.
// Foam is the maximum over a past, so the mean of its powers has no closed form; it is measured by
// following the gradients of the displacement at single labels, tick by tick of the foam's clock.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "ocean/internal/foam.hpp"
#include "waves/foam/foam_ages.hpp"
#include "waves/foam/gradient_process.hpp"
#include "waves/foam/jacobian_nodes.hpp"
#include "waves/foam/label_windows.hpp"
#include "waves/foam/whitecap_gradients.hpp"

namespace ocean {
namespace {

/// Returns the age, in lifetimes, of a whitecap's foam over older foam, as foam_with_whitecap of
/// shaders/wave/foam_cover.glsl does where a lattice is spread.
double age_under(double whitecap_age, double foam_age) {
    return std::min(foam_age, whitecap_age + std::max(0.0, foam_age - std::log(2.0)));
}

/// Follows labels through a whitecap of the past in the middle of a window.
///
/// E[F^n] is the sum, over the ticks s of the last `reach`, of E[F^n / N; V(s) > 0], where N of
/// these ticks have a whitecap of the past V > 0: each counts for its share in the foam that
/// follows.
class Follower {
  public:
    /// `aging`: the age that foam gains in a tick.
    Follower(int reach, double aging) : reach_(static_cast<std::size_t>(reach)), aging_(aging) {}

    /// Begins a window.
    void begin() {
        past_.clear();
        ages_.clear();
        shown_.clear();
    }
    /// Adds a tick: the whitecap of the past, and the whitecap shown over it.
    void add_tick(double past, double shown) {
        past_.push_back(past);
        ages_.push_back(age_of(past));
        shown_.push_back(age_of(shown));
    }
    void follow(FollowedFoam& followed) {
        if (ages_[reach_] == kNoFoam) return;  // happens by rounding alone
        // The waves' statistics are the same backwards in time.
        add(followed);
        for (std::vector<double>* ticks : {&past_, &ages_, &shown_}) std::ranges::reverse(*ticks);
        add(followed);
    }

  private:
    void add(FollowedFoam& followed) const {
        double age = kNoFoam;
        int makers = 0;
        for (std::size_t t = 0; t < ages_.size(); ++t) {
            age = std::min(ages_[t], age + aging_);
            makers += ages_[t] != kNoFoam ? 1 : 0;
            if (t < reach_) continue;
            followed.foam.add(age_under(shown_[t], age), 1.0 / makers);
            followed.whitecap += past_[t] / makers;
            makers -= ages_[t - reach_] != kNoFoam ? 1 : 0;
        }
    }

    std::size_t reach_;
    double aging_;
    std::vector<double> past_;
    std::vector<double> ages_;   // -ln past
    std::vector<double> shown_;  // -ln of the shown whitecaps
};

/// The waves that a map holds but a foam lattice does not.
class ShortWaves {
  public:
    ShortWaves(const FoamSea& sea, const FoamWhitecaps& whitecaps, double angle,
               const Stretch& stretch)
        : process_(sea, {whitecaps.shown.held_by, whitecaps.past.held_by},
                   without(whitecaps.shown.covariance, whitecaps.past.covariance), angle, stretch) {
    }

    std::array<std::vector<Gradients>, 2> draw(std::uint32_t number) const {
        return process_.draw(number, 1);
    }

  private:
    static GradientCovariance without(const GradientCovariance& all,
                                      const GradientCovariance& part) {
        GradientCovariance rest = part;
        rest *= -1.0;
        rest += all;
        return rest;
    }

    GradientProcess process_;
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

double cover_power(const FoamSea& sea, const FoamWhitecaps& whitecaps, ThreadPool& pool) {
    const SurfaceSettings& surface = sea.parameters.surface;
    const Whitecaps& past = whitecaps.past;
    const Whitecaps& shown = whitecaps.shown;
    const bool squeezed = surface.choppiness > 0.0 && past.covariance.aa + past.covariance.bb > 0.0;
    if (!squeezed || surface.foam_lifetime <= 0.0) return 1.0;
    const Stretch stretch =
        stretch_of(foam_clock(surface, sea.parameters.time.loop_period), surface.foam_lifetime);
    const double angle = principal_angle(past.covariance);
    const GradientProcess process(sea, {past.held_by}, past.covariance, angle, stretch);
    const WhitecapGradients gradients(process.covariance(), surface.choppiness, past.threshold);
    if (!(gradients.share() > 0.0)) return 1.0;
    std::optional<ShortWaves> short_waves;
    if (shown.covariance != past.covariance) {
        short_waves.emplace(sea, whitecaps, angle, stretch);
    }
    const double aging = stretch.step() / surface.foam_lifetime;
    const auto follow_draw = [&](int draw, FollowedFoam& followed) {
        const auto number = static_cast<std::uint32_t>(draw);
        const auto stretches = process.draw(number);
        std::array<std::vector<Gradients>, 2> short_stretches;
        if (short_waves) short_stretches = short_waves->draw(number);
        Follower follower(stretch.reach, aging);
        std::vector<Gradients> window;
        for (int i = 0; i < kWindowsOfDraw; ++i) {
            const WindowPlace place = window_place(stretch, draw, i);
            process.passing(gradients.at(place.of_nodes, place.of_depth), place.tick, stretch.reach,
                            stretches[place.stretch], window);
            const std::vector<Gradients>& added = short_stretches[place.stretch];
            const auto ticks = static_cast<std::size_t>(stretch.ticks);
            std::size_t tick = place.tick + ticks - static_cast<std::size_t>(stretch.reach);
            follower.begin();
            for (const Gradients& g : window) {
                const double whitecap = whitecap_of(g, surface, past.threshold);
                const Gradients all = short_waves ? g + added[tick++ % ticks] : g;
                follower.add_tick(
                    whitecap, short_waves ? whitecap_of(all, surface, shown.threshold) : whitecap);
            }
            follower.follow(followed);
        }
    };
    FollowedFoam followed = follow_draws(stretch, pool, follow_draw);
    if (short_waves) {
        const auto mean = [&](const Whitecaps& w) {
            return mean_whitecap(w.covariance, surface.choppiness, w.threshold, surface.foam_width);
        };
        followed.whitecap *= mean(shown) / mean(past);
    }
    return followed.power();
}

}  // namespace ocean
