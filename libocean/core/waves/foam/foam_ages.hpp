// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The distribution of the ages of foam, which determines the power of the cover.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace ocean {

inline constexpr double kNoFoam = 1e9;  // the age where W = 0

/// Returns the age -ln W of a whitecap W as foam.
inline double age_of(double whitecap) {
    return whitecap <= 0.0 ? kNoFoam : whitecap >= 1.0 ? 0.0 : -std::log(whitecap);
}

/// A distribution of foam F by its age, -ln F.
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
            // Full whitecaps are a step of the distribution.
            sum += weights_[i] * (i == 0 ? 1.0 : std::exp(-power * root * root));
        }
        return sum;
    }

  private:
    static constexpr double kPerRoot = 500.0;
    std::array<double, 1252> weights_{};  // up to ln 512; older foam is gone
};

/// Sums over followed labels of the foam's ages and of the whitecaps, with the same weights.
struct FollowedFoam {
    FoamAges foam;
    double whitecap = 0.0;

    void add(const FollowedFoam& other) {
        foam.add(other.foam);
        whitecap += other.whitecap;
    }
    /// Returns n, 1 to 10^4, at which the sums of F^n and of the whitecaps are equal.
    double power() const;
};

}  // namespace ocean
