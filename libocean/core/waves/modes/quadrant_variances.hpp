// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The variances of the modes of two rows that are each other's mirror image in the axis.
#pragma once

#include <vector>

namespace ocean {

/// Variances [m^2] of the modes (n, m), (-n, m), (-n, -m), (n, -m), by n = 0 .. N/2 - 1. On an axis
/// two of these are the same mode, and both contain it: the first and the last for n = 0, the first
/// two for m = 0.
struct QuadrantVariances {
    std::vector<double> quarter[4];

    double sum(std::size_t n) const {
        return quarter[0][n] + quarter[1][n] + quarter[2][n] + quarter[3][n];
    }
};

}  // namespace ocean
