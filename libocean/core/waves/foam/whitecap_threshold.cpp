// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The amount of whitecaps: the Jacobian threshold at which the ensemble mean of W equals the
// coverage that the wind makes. It follows from the modes' gradient covariance alone; the surface
// then applies it.
#include "waves/foam/whitecap_threshold.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "ocean/internal/foam.hpp"
#include "ocean/internal/grid.hpp"
#include "waves/foam/jacobian_nodes.hpp"

namespace ocean {

namespace {
/// Every float Jacobian is larger, so that W is exactly 0.
constexpr double kNoWhitecap = std::numeric_limits<float>::lowest();

/// Returns E[max(x, 0)] of a Gaussian x = sd (z + Z), over sd: G(z) = z Phi(z) + phi(z).
double positive_part(double z) {
    constexpr double kFar = 9.0;  // Phi(-9) = 1e-19
    if (z < -kFar) return 0.0;
    if (z > kFar) return z;
    return 0.5 * z * std::erfc(-z / std::sqrt(2.0)) + std::exp(-0.5 * z * z) / std::sqrt(kTwoPi);
}

/// E[W] as a function of the threshold: with m and sd the mean and the deviation of J at a node,
/// E[W | node] = (sd/w) (G((th - m)/sd) - G((th - w - m)/sd)).
/// Proved by Foam.TheMeanWhitecapIsThatOfRandomGradients.
class MeanWhitecap {
  public:
    MeanWhitecap(const GradientCovariance& covariance, double choppiness)
        : nodes_(jacobian_nodes(in_principal_axes(covariance), choppiness)) {}

    double operator()(double threshold, double width) const {
        double sum = 0.0;
        for (const JacobianNode& node : nodes_) {
            const double depth = threshold - node.mean;
            const double sd = std::abs(node.slope);
            if (sd > 0.0) {
                sum += node.weight * sd *
                       (positive_part(depth / sd) - positive_part((depth - width) / sd));
            } else {
                sum += node.weight * std::clamp(depth, 0.0, width);
            }
        }
        return sum / width;
    }

  private:
    std::vector<JacobianNode> nodes_;
};

}  // namespace

double monahan_coverage(double wind_speed) {
    // [Monahan and O'Muircheartaigh 1980]
    return std::min(1.0, 3.84e-6 * std::pow(std::max(0.0, wind_speed), 3.41));
}

double mean_whitecap(const GradientCovariance& covariance, double choppiness, double threshold,
                     double width) {
    return MeanWhitecap(covariance, choppiness)(threshold, width);
}

double folded_share(const GradientCovariance& covariance, double choppiness) {
    constexpr double kJump = 1e-6;
    return mean_whitecap(covariance, choppiness, 0.0, kJump);
}

double whitecap_threshold(const GradientCovariance& covariance, const SurfaceSettings& settings,
                          double wind_speed) {
    if (settings.foam_coverage == FoamCoverage::threshold) return settings.foam_threshold;
    return threshold_of_mean(covariance, settings, monahan_coverage(wind_speed), 1.0);
}

double threshold_of_mean(const GradientCovariance& covariance, const SurfaceSettings& settings,
                         double wanted, double highest) {
    const bool squeezed = settings.choppiness > 0.0 && covariance.aa + covariance.bb > 0.0;
    if (wanted <= 0.0 || !squeezed) return kNoWhitecap;

    const MeanWhitecap mean(covariance, settings.choppiness);
    double below = highest;  // the answer if even `highest` gives too little
    double above = highest;
    for (double fall = 0.25; mean(below, settings.foam_width) > wanted; fall *= 2.0) {
        above = below;
        below = highest - fall;
    }
    while (above - below > 1e-9 * std::max(1.0, std::abs(below))) {
        const double middle = 0.5 * (below + above);
        (mean(middle, settings.foam_width) > wanted ? above : below) = middle;
    }
    return 0.5 * (below + above);
}

SurfaceSettings with_threshold(const SurfaceSettings& settings, const Modes& modes,
                               int resolution) {
    SurfaceSettings result = settings;
    result.foam_threshold =
        whitecap_threshold(modes.gradient_covariance(resolution), settings, modes.wind_speed);
    result.foam_coverage = FoamCoverage::threshold;
    return result;
}

}  // namespace ocean
