// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The exponent p of cover = foam^p, at which the mean of foam^p equals that of the whitecaps. Foam
// is the maximum over a past, so the mean of its powers has no closed form; it is measured by
// following the gradients of the displacement at single labels, tick by tick of the foam's clock.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "foam/gradient_process.hpp"
#include "foam/jacobian_nodes.hpp"
#include "ocean/foam.hpp"
#include "ocean/thread_pool.hpp"

namespace ocean {
namespace {

constexpr double kMaxPower = 1e4;

/// Returns P(Z > z).
double upper_tail(double z) {
    return 0.5 * std::erfc(z / std::sqrt(2.0));
}

/// Returns the z with P(Z > z) = share P(Z > from).
double beyond(double from, double share) {
    const double wanted = share * upper_tail(from);
    double low = from, high = from + 10.0;
    for (int i = 0; i < 50; ++i) {
        const double middle = 0.5 * (low + high);
        (upper_tail(middle) > wanted ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

/// Draws the gradients at a label that has a whitecap.
class WhitecapGradients {
  public:
    WhitecapGradients(const GradientCovariance& covariance, double choppiness, double threshold)
        : factors_(covariance),
          threshold_(threshold),
          nodes_(jacobian_nodes(covariance, choppiness)) {
        double sum = 0.0;
        for (const JacobianNode& node : nodes_) {
            const double depth = threshold - node.mean;
            const double share = node.slope != 0.0 ? upper_tail(-depth / std::abs(node.slope))
                                                   : (depth > 0.0 ? 1.0 : 0.0);
            up_to_.push_back(sum += node.weight * share);
        }
    }

    bool any() const { return up_to_.back() > 0.0; }

    /// Returns the gradients for two uniform numbers in (0, 1).
    GradientProcess::Gradients at(double of_nodes, double of_depth) const {
        const auto found = std::ranges::upper_bound(up_to_, of_nodes * up_to_.back());
        const auto i =
            std::min(static_cast<std::size_t>(found - up_to_.begin()), nodes_.size() - 1);
        const JacobianNode& node = nodes_[i];
        double z = 0.0;
        if (node.slope != 0.0) {
            const double size = std::abs(node.slope);
            z = -std::copysign(1.0, node.slope) * beyond((node.mean - threshold_) / size, of_depth);
        }
        const GradientFactors& f = factors_;
        return {f.a1 * node.x + f.a2 * node.y + f.a3 * z, f.b1 * node.x,
                f.c1 * node.x + f.c2 * node.y};
    }

  private:
    GradientFactors factors_;
    double threshold_;
    std::vector<JacobianNode> nodes_;
    std::vector<double> up_to_;  // the share of whitecaps at this node and those before
};

/// How often foam is how much: by its age, -ln F.
class FoamAges {
  public:
    void add(double age, double weight) {
        const auto bin = static_cast<std::size_t>(kPerRoot * std::sqrt(age));
        weights_[std::min(bin, weights_.size() - 1)] += weight;
    }
    void add(const FoamAges& other) {
        for (std::size_t i = 0; i < weights_.size(); ++i) weights_[i] += other.weights_[i];
    }
    /// Returns the sum of F^power.
    double sum(double power) const {
        double sum = 0.0;
        for (std::size_t i = 0; i < weights_.size(); ++i) {
            const double root = (static_cast<double>(i) + 0.5) / kPerRoot;
            // Whole whitecaps are a step of the distribution.
            sum += weights_[i] * (i == 0 ? 1.0 : std::exp(-power * root * root));
        }
        return sum;
    }

  private:
    static constexpr double kPerRoot = 500.0;
    std::array<double, 1252> weights_{};  // to ln 512, beyond which foam is 0
};

/// Sums over the followed labels that have a whitecap.
struct Followed {
    FoamAges foam;
    double whitecap = 0.0;

    void add(const Followed& other) {
        foam.add(other.foam);
        whitecap += other.whitecap;
    }
};

/// Follows labels through a whitecap in the middle of a window.
class Follower {
  public:
    /// Takes the settings of the displayed map. `aging`: of foam in a tick.
    Follower(const SurfaceSettings& shown, int reach, double aging)
        : shown_(shown), reach_(static_cast<std::size_t>(reach)), aging_(aging) {}

    /// Adds E[F^n] as the sum, over the ticks s of its last `reach`, of E[F^n / N; W(s) > 0], where
    /// N of them have W > 0: each whitecap counts for its share in the foam that follows.
    void follow(std::span<const GradientProcess::Gradients> window, Followed& followed) {
        const double c = shown_.choppiness;
        fresh_.clear();
        whitecaps_.clear();
        for (const auto& g : window) {
            const double jacobian = (1.0 - c * g.a) * (1.0 - c * g.b) - c * c * g.c * g.c;
            const double depth = (shown_.foam_threshold - jacobian) / shown_.foam_width;
            whitecaps_.push_back(std::clamp(depth, 0.0, 1.0));
            fresh_.push_back(depth <= 0.0 ? kNone : depth >= 1.0 ? 0.0 : -std::log(depth));
        }
        if (fresh_[reach_] == kNone) return;  // by rounding alone
        // The waves' statistics are the same backwards in time.
        add(followed);
        std::ranges::reverse(fresh_);
        std::ranges::reverse(whitecaps_);
        add(followed);
    }

  private:
    static constexpr double kNone = 1e9;

    void add(Followed& followed) const {
        double age = kNone;
        int whitecaps = 0;
        for (std::size_t t = 0; t < fresh_.size(); ++t) {
            age = std::min(fresh_[t], age + aging_);
            whitecaps += fresh_[t] != kNone ? 1 : 0;
            if (t < reach_) continue;
            followed.foam.add(age, 1.0 / whitecaps);
            followed.whitecap += whitecaps_[t] / whitecaps;
            whitecaps -= fresh_[t - reach_] != kNone ? 1 : 0;
        }
    }

    const SurfaceSettings& shown_;
    std::size_t reach_;
    double aging_;
    std::vector<double> whitecaps_;
    std::vector<double> fresh_;  // the age of whitecaps as foam
};

}  // namespace

double cover_power(const CoverPowerInput& sea, const GradientCovariance& covariance,
                   ThreadPool& pool) {
    const SurfaceSettings& shown = sea.parameters.surface;
    const bool squeezed = shown.choppiness > 0.0 && covariance.aa + covariance.bb > 0.0;
    if (!squeezed || shown.foam_lifetime <= 0.0) return 1.0;
    const Stretch stretch =
        stretch_of(foam_clock(shown, sea.parameters.time.loop_period), shown.foam_lifetime);
    const GradientProcess process(sea, covariance, stretch);
    const WhitecapGradients whitecaps(process.covariance(), shown.choppiness, shown.foam_threshold);
    if (!whitecaps.any()) return 1.0;
    // Two stretches a draw, and whitecaps in them that know little of each other.
    constexpr int kDraws = 256;
    constexpr int kWindows = 64;
    constexpr int kTicks = 1 << 23;
    const int draws = std::clamp(kTicks / (2 * stretch.reach * kWindows), 4, kDraws);
    const double aging = stretch.step() / shown.foam_lifetime;
    std::vector<Followed> parts(static_cast<std::size_t>(draws));
    pool.for_each_item(draws, [&](int draw, int) {
        const auto stretches = process.draw(static_cast<std::uint32_t>(draw));
        Follower follower(shown, stretch.reach, aging);
        std::vector<GradientProcess::Gradients> window;
        for (int i = 0; i < kWindows; ++i) {
            const auto tick =
                static_cast<std::size_t>(static_cast<std::int64_t>(i) * stretch.ticks / kWindows);
            // Places of the two-dimensional golden ratio: as even as a lattice, for any number.
            const double number = draw * kWindows + i + 0.5;
            const double of_nodes = number * 0.7548776662466927;
            const double of_depth = number * 0.5698402909980532;
            process.passing(
                whitecaps.at(of_nodes - std::floor(of_nodes), of_depth - std::floor(of_depth)),
                tick, stretch.reach, stretches[static_cast<std::size_t>(i % 2)], window);
            follower.follow(window, parts[static_cast<std::size_t>(draw)]);
        }
    });
    Followed all;
    for (const Followed& part : parts) all.add(part);
    double low = 0.0, high = std::log(kMaxPower);
    if (all.foam.sum(1.0) <= all.whitecap) return 1.0;
    for (int i = 0; i < 40; ++i) {
        const double middle = 0.5 * (low + high);
        (all.foam.sum(std::exp(middle)) > all.whitecap ? low : high) = middle;
    }
    return std::exp(0.5 * (low + high));
}

}  // namespace ocean
