// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Bounds of volumes and their files, which need no OpenVDB.
#include <algorithm>
#include <cmath>

#include "ocean/error.hpp"
#include "ocean/internal/text.hpp"
#include "ocean/io/vdb.hpp"

namespace ocean::io {

VoxelRange voxels_around(const WorldBox& box, double size, int beyond) {
    constexpr double kFarthest = 1 << 30;
    VoxelRange range{{}, {}, size};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        // A remainder by rounding is not a voxel.
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

double density_reach(const DensityPuff& puff, double voxel) {
    constexpr double kMinDeviation = 0.75;  // [voxels]; narrower puffs would fall between samples
    return kPuffReach * std::max(puff.deviation, kMinDeviation * voxel);
}

std::uint64_t points_vdb_bytes(std::uint64_t count, std::uint64_t leaves) {
    // The offsets of 8^3 cells, and the overhead of each attribute.
    constexpr std::uint64_t kLeaf = 4096;
    return points_bytes(count) + std::min(count, leaves) * kLeaf;
}

}  // namespace ocean::io
