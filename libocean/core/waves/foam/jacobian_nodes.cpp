// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "waves/foam/jacobian_nodes.hpp"

#include <algorithm>
#include <cmath>

namespace ocean {

double principal_angle(const GradientCovariance& v) {
    return 0.5 * std::atan2(2.0 * (v.ac + v.bc), v.aa - v.bb);
}

GradientCovariance in_principal_axes(const GradientCovariance& v) {
    const double angle = principal_angle(v);
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    // Each row is the weights with which (a, b, c) becomes one gradient along the new axes.
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

GradientFactors::GradientFactors(const GradientCovariance& v) {
    const double least = 1e-14 * (v.aa + v.bb + v.cc);
    const auto root = [least](double x) { return x > least ? std::sqrt(x) : 0.0; };
    const auto over = [](double x, double divisor) { return divisor > 0.0 ? x / divisor : 0.0; };
    b1 = root(v.bb);
    c1 = over(v.bc, b1);
    c2 = root(v.cc - c1 * c1);
    a1 = over(v.ab, b1);
    a2 = over(v.ac - a1 * c1, c2);
    a3 = root(v.aa - a1 * a1 - a2 * a2);
}

std::vector<JacobianNode> jacobian_nodes(const GradientCovariance& covariance, double choppiness) {
    constexpr double kReach = 6.5;
    const GradientFactors f(covariance);
    const double size = std::sqrt(covariance.aa + covariance.bb + covariance.cc);
    const double own = size > 0.0 ? f.a3 / size : 1.0;
    const double spacing = std::clamp(own, 0.05, 0.5);
    const int reach = static_cast<int>(std::ceil(kReach / spacing));
    std::vector<JacobianNode> nodes;
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
            nodes.push_back(
                {x, y, along * across - shear * shear, -choppiness * across * f.a3, weight});
            total += weight;
        }
    }
    for (JacobianNode& node : nodes) node.weight /= total;
    return nodes;
}

}  // namespace ocean
