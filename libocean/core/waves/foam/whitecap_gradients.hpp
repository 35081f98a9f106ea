// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The gradients of the displacement at labels that have a whitecap.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "ocean/parameters.hpp"
#include "waves/foam/gradient_process.hpp"
#include "waves/foam/jacobian_nodes.hpp"

namespace ocean {

/// Returns P(Z > z) of a standard normal Z.
inline double upper_tail(double z) {
    return 0.5 * std::erfc(z / std::sqrt(2.0));
}

/// Returns the z with P(Z > z) = share P(Z > from).
inline double beyond(double from, double share) {
    const double wanted = share * upper_tail(from);
    double low = from, high = from + 10.0;
    for (int i = 0; i < 50; ++i) {
        const double middle = 0.5 * (low + high);
        (upper_tail(middle) > wanted ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

/// Returns W = clamp((threshold - J) / width, 0, 1), J = (1 - C a)(1 - C b) - C^2 c^2.
inline double whitecap_of(const Gradients& g, const SurfaceSettings& settings, double threshold) {
    const double c = settings.choppiness;
    const double jacobian = (1.0 - c * g.a) * (1.0 - c * g.b) - c * c * g.c * g.c;
    return std::clamp((threshold - jacobian) / settings.foam_width, 0.0, 1.0);
}

/// Draws the gradients at a label where J < threshold, distributed as in the sea.
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

    /// Returns P(J < threshold).
    double share() const { return up_to_.back(); }

    /// Returns the gradients at two shares in (0, 1), which select the node and the depth below the
    /// threshold. Uniform shares give the distribution. Requires share() > 0.
    Gradients at(double of_nodes, double of_depth) const {
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
    std::vector<double> up_to_;  // the share of whitecaps up to this node
};

}  // namespace ocean
