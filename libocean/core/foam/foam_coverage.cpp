// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// How much whitecap there is: the Jacobian threshold at which the ensemble mean of W is what the
// wind makes. From the modes' gradient covariance alone; the surface then applies the threshold.
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "ocean/foam.hpp"
#include "ocean/grid.hpp"

namespace ocean {

namespace {

/// Every float Jacobian lies above: W is exactly 0.
constexpr double kNoWhitecap = std::numeric_limits<float>::lowest();

/// The covariance seen from axes turned to the principal direction of the waves. J is a determinant
/// and does not change; a long-crested sea becomes a sea of `a` alone.
GradientCovariance along_the_waves(const GradientCovariance& v) {
    const double angle = 0.5 * std::atan2(2.0 * (v.ac + v.bc), v.aa - v.bb);
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    // Each row turns (a, b, c) into one gradient along the new axes.
    const double rows[3][3] = {
        {c * c, s * s, 2.0 * s * c}, {s * s, c * c, -2.0 * s * c}, {-s * c, s * c, c * c - s * s}};
    const double old[3][3] = {{v.aa, v.ab, v.ac}, {v.ab, v.bb, v.bc}, {v.ac, v.bc, v.cc}};
    const auto turned = [&](int i, int j) {
        double sum = 0.0;
        for (int p = 0; p < 3; ++p) {
            for (int q = 0; q < 3; ++q) sum += rows[i][p] * old[p][q] * rows[j][q];
        }
        return sum;
    };
    return {turned(0, 0), turned(1, 1), turned(2, 2), turned(0, 1), turned(0, 2), turned(1, 2)};
}

/// a, b and c as sums of three standard normals, b from the first, c from two. A direction without
/// variance has a factor of 0.
struct Factors {
    double b1, c1, c2, a1, a2, a3;

    explicit Factors(const GradientCovariance& v) {
        const double least = 1e-14 * (v.aa + v.bb + v.cc);
        const auto root = [least](double x) { return x > least ? std::sqrt(x) : 0.0; };
        const auto over = [](double x, double divisor) {
            return divisor > 0.0 ? x / divisor : 0.0;
        };
        b1 = root(v.bb);
        c1 = over(v.bc, b1);
        c2 = root(v.cc - c1 * c1);
        a1 = over(v.ab, b1);
        a2 = over(v.ac - a1 * c1, c2);
        a3 = root(v.aa - a1 * a1 - a2 * a2);
    }
};

/// E[max(x, 0)] of a Gaussian x = sd (z + Z), over sd: G(z) = z Phi(z) + phi(z).
double positive_part(double z) {
    constexpr double kFar = 9.0;  // Phi(-9) = 1e-19
    if (z < -kFar) return 0.0;
    if (z > kFar) return z;
    return 0.5 * z * std::erfc(-z / std::sqrt(2.0)) + std::exp(-0.5 * z * z) / std::sqrt(kTwoPi);
}

/// E[W] as a function of the threshold. With b and c given, J = (1 - C a)(1 - C b) - C^2 c^2 is
/// linear in `a` and so Gaussian: E[W | b, c] = (sd/w) (G((th - m)/sd) - G((th - w - m)/sd)), m and
/// sd the mean and deviation of J. It is smooth in b and c: the trapezoid rule over two standard
/// normals converges faster than any power of its spacing, as long as sd spans a few of them. Where
/// `a` hardly varies by itself (two swells that cross) it is closer, and its terms are cheap.
/// Proved by Foam.TheMeanWhitecapIsThatOfRandomGradients.
class MeanWhitecap {
  public:
    MeanWhitecap(const GradientCovariance& covariance, double choppiness) {
        constexpr double kReach = 6.5;
        const Factors f(along_the_waves(covariance));
        const double size = std::sqrt(covariance.aa + covariance.bb + covariance.cc);
        const double own = size > 0.0 ? f.a3 / size : 1.0;
        const double spacing = std::clamp(own, 0.05, 0.5);
        const int reach = static_cast<int>(std::ceil(kReach / spacing));
        double total = 0.0;
        for (int i = -reach; i <= reach; ++i) {
            for (int j = -reach; j <= reach; ++j) {
                if (i * i + j * j > reach * reach) continue;
                const double x = spacing * i;
                const double y = spacing * j;
                const double across = 1.0 - choppiness * f.b1 * x;
                const double shear = choppiness * (f.c1 * x + f.c2 * y);
                const double along = 1.0 - choppiness * (f.a1 * x + f.a2 * y);
                const double weight = std::exp(-0.5 * (x * x + y * y));
                nodes_.push_back(
                    {along * across - shear * shear, std::abs(choppiness * across * f.a3), weight});
                total += weight;
            }
        }
        for (Node& node : nodes_) node.weight /= total;
    }

    double operator()(double threshold, double width) const {
        double sum = 0.0;
        for (const Node& node : nodes_) {
            const double depth = threshold - node.mean;
            if (node.deviation > 0.0) {
                const double sd = node.deviation;
                sum += node.weight * sd *
                       (positive_part(depth / sd) - positive_part((depth - width) / sd));
            } else {
                sum += node.weight * std::clamp(depth, 0.0, width);
            }
        }
        return sum / width;
    }

  private:
    struct Node {
        double mean;
        double deviation;
        double weight;
    };
    std::vector<Node> nodes_;
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
    const double wanted = monahan_coverage(wind_speed);
    const bool squeezed = settings.choppiness > 0.0 && covariance.aa + covariance.bb > 0.0;
    if (wanted <= 0.0 || !squeezed) return kNoWhitecap;

    const MeanWhitecap mean(covariance, settings.choppiness);
    constexpr double kHighest = 1.0;  // and the answer where even that gives too little
    double below = kHighest;
    double above = kHighest;
    for (double fall = 0.25; mean(below, settings.foam_width) > wanted; fall *= 2.0) {
        above = below;
        below = kHighest - fall;
    }
    while (above - below > 1e-9 * std::max(1.0, std::abs(below))) {
        const double middle = 0.5 * (below + above);
        (mean(middle, settings.foam_width) > wanted ? above : below) = middle;
    }
    return 0.5 * (below + above);
}

}  // namespace ocean
