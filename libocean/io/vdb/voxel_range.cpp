// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "ocean/error.hpp"
#include "ocean/io/vdb.hpp"
#include "ocean/text.hpp"

namespace ocean::io {

VoxelRange voxels_around(const WorldBox& box, double size, int beyond) {
    constexpr double kFarthest = 1 << 30;
    VoxelRange range{{}, {}, size};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        // A remainder of rounding is not a voxel.
        constexpr double kRounding = 1e-9;
        const double low = std::ceil(box.low[axis] / size - kRounding) - beyond;
        const double high = std::floor(box.high[axis] / size + kRounding) + beyond;
        const bool is_box = size > 0.0 && box.low[axis] < box.high[axis];
        // Also false for NaN.
        if (!(is_box && -kFarthest <= low && low <= high && high <= kFarthest)) {
            throw Error(ErrorKind::invalid_value,
                        format_text("a box from %g to %g m has no voxels of %g m, or too many",
                                    box.low[axis], box.high[axis], size));
        }
        range.first[axis] = static_cast<int>(low);
        range.count[axis] = static_cast<int>(high - low) + 1;
    }
    return range;
}

}  // namespace ocean::io
