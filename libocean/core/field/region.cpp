// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "ocean/domain.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "ocean/error.hpp"
#include "ocean/internal/text.hpp"

namespace ocean {

Domain domain_of(const Region& region) {
    Domain domain{region.origin, {}, {}, false};
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const double steps = std::floor(region.size[axis] / region.cell * (1.0 + 1e-12) + 1e-9);
        if (!(steps >= 1.0 && steps < kMaxRegionSide)) {
            throw Error(ErrorKind::invalid_value,
                        "the region has " + fixed_text(steps + 1.0, 0) + " samples along " +
                            (axis == 0 ? "x" : "y") + " at a cell of " +
                            shortest_text(region.cell) + " m; allowed: 2 .. " +
                            std::to_string(kMaxRegionSide));
        }
        domain.samples[axis] = static_cast<int>(steps) + 1;
        domain.size[axis] = steps * region.cell;
    }
    return domain;
}

Domain with_cell(Domain domain, double cell) {
    constexpr double kRounding = 1e-6;  // share of a cell
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const int steps =
            std::max(1, static_cast<int>(std::floor(domain.size[axis] / cell + kRounding)));
        domain.samples[axis] = steps + 1;
        domain.size[axis] = steps * cell;
    }
    return domain;
}

}  // namespace ocean
