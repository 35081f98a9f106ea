// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A map of scalars over the bed of a coast, on square cells: the depth that waves feel, the height
// of the bed, a share of energy.
#pragma once

#include <vector>

#include "ocean/domain.hpp"

namespace ocean {

/// Row-major [j][i], sample (i, j) at domain.place(i, j). domain.wraps is false and
/// domain.step(0) == domain.step(1).
struct BedGrid {
    Domain domain{.wraps = false};
    std::vector<float> values;

    double cell() const { return domain.step(0); }
    float at(int i, int j) const {
        return values[static_cast<std::size_t>(j) * static_cast<std::size_t>(domain.samples[0]) +
                      static_cast<std::size_t>(i)];
    }
};

}  // namespace ocean
