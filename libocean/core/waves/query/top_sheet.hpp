// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Selects the label seen from above among the labels shown at one place.
#pragma once

#include <optional>
#include <utility>

#include "waves/query/inversion.hpp"
#include "waves/query/spline_map.hpp"

namespace ocean {

/// A label, and the map's values there.
struct Solution {
    ShownLabel label;
    SplineJet jet;

    double height() const { return static_cast<double>(jet.value[2]); }
};

inline DisplacementSample displacement_of(const SplineJet& jet) {
    return {-static_cast<double>(jet.value[0]), -static_cast<double>(jet.value[1]),
            -static_cast<double>(jet.by_x[0]), -static_cast<double>(jet.by_y[1]),
            -0.5 * (static_cast<double>(jet.by_y[0]) + static_cast<double>(jet.by_x[1]))};
}

/// Finds the highest of the solutions that starts lead to.
class TopSheet {
  public:
    void add(const Solution& solution) {
        folded_ = folded_ || (solution.label.converged && solution.label.jacobian <= 0.0);
        if (!top_ || rank(solution) > rank(*top_)) top_ = solution;
    }
    bool converged() const { return top_ && top_->label.converged; }
    bool folded() const { return folded_; }
    const Solution& top() const { return *top_; }

  private:
    static std::pair<bool, double> rank(const Solution& solution) {
        return {solution.label.converged, solution.height()};
    }
    std::optional<Solution> top_;
    bool folded_ = false;
};

}  // namespace ocean
