// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The slowness of waves of one frequency over a bed, relative to the open sea.
#pragma once

#include <vector>

#include "ocean/parameters.hpp"

namespace ocean {

/// The wavenumber at a depth relative to the open sea, k(omega, d) / k(omega, water.depth), for
/// waves of one frequency, in a table over the root of the depth. Immutable.
class Slowness {
  public:
    /// k: wavenumber in the open sea [rad/m]. min_depth: start of the table, > 0 [m].
    Slowness(double k, const Water& water, double min_depth);

    /// Returns the slowness at a depth [m]. It is exactly 1 at the open sea's depth and where k d >
    /// 5, because a change below 1e-4 counts as 0.
    float at(double depth) const;

  private:
    double first_;    // root of min_depth
    double scale_;    // entries per root of a metre
    double deepest_;  // where the table ends [m]
    std::vector<float> table_;
};

}  // namespace ocean
