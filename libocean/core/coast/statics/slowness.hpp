// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// How much slower than in the open sea waves of one frequency travel over a bed.
#pragma once

#include <vector>

#include "ocean/parameters.hpp"

namespace ocean {

/// The wavenumber at a depth over that in the open sea, k(omega, d) / k(omega, water.depth), for
/// waves of one frequency, in a table over the root of the depth. Immutable.
class Slowness {
  public:
    /// k: wavenumber in the open sea [rad/m]. min_depth: the table begins there, > 0 [m].
    Slowness(double k, const Water& water, double min_depth);

    /// Returns the slowness at a depth [m]. It is 1 exactly in the open sea's own depth and where
    /// k d > 5, because a change below 1e-4 counts as none.
    float at(double depth) const;

  private:
    double first_;    // root of the least depth
    double scale_;    // entries per root of a metre
    double deepest_;  // where the table ends [m]
    std::vector<float> table_;
};

}  // namespace ocean
