// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "waves/crests/dependent_rows.hpp"

#include <cmath>
#include <numeric>

namespace ocean {

DependentRows::DependentRows(const Gram& gram) : lower_(gram.size), scale_(gram.size) {
    // A row keeps this share of its variance when those before it are known, or depends on them:
    // 1e-5 of its root mean square, below a hundredth of a millimetre for any sea.
    constexpr double kOwnShare = 1e-10;
    for (std::size_t i = 0; i < gram.size; ++i) {
        scale_[i] = gram.at(i, i) > 0.0 ? 1.0 / std::sqrt(gram.at(i, i)) : 0.0;
        for (std::size_t j = 0; j <= i; ++j) {
            double rest = gram.at(i, j) * scale_[i] * scale_[j];
            for (std::size_t k = 0; k < j; ++k) rest -= lower_.at(i, k) * lower_.at(j, k);
            if (i == j) {
                lower_.at(i, i) = rest > kOwnShare ? std::sqrt(rest) : 0.0;
            } else {
                lower_.at(i, j) = is_dependent(j) ? 0.0 : rest / lower_.at(j, j);
            }
        }
    }
}

std::vector<double> DependentRows::forward(std::span<const double> right) const {
    std::vector<double> x(right.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
        if (is_dependent(i)) continue;
        double rest = right[i] * scale_[i];
        for (std::size_t k = 0; k < i; ++k) rest -= lower_.at(i, k) * x[k];
        x[i] = rest / lower_.at(i, i);
    }
    return x;
}

double DependentRows::form(std::span<const double> right) const {
    const std::vector<double> x = forward(right);
    return std::inner_product(x.begin(), x.end(), x.begin(), 0.0);
}

std::vector<double> DependentRows::solve(std::span<const double> right) const {
    std::vector<double> x = forward(right);
    for (std::size_t i = x.size(); i-- > 0;) {
        if (is_dependent(i)) continue;
        double rest = x[i];
        for (std::size_t k = i + 1; k < x.size(); ++k) rest -= lower_.at(k, i) * x[k];
        x[i] = rest / lower_.at(i, i);
    }
    for (std::size_t i = 0; i < x.size(); ++i) x[i] *= scale_[i];
    return x;
}

}  // namespace ocean
