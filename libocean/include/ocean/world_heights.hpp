// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Heights by place instead of by label, for formats without overhangs: the displacement inverted,
// of folds the top sheet.
#pragma once

#include <cstddef>
#include <cstdint>

#include "ocean/ocean.hpp"
#include "ocean/subject.hpp"

namespace ocean {

/// On resolution^2 places of the period. Throws what Ocean::query throws.
WorldHeights world_heights(Ocean& ocean, double time, int resolution);
/// Bytes that it needs beside the surface, at most; 0 for a sea that is never displaced.
std::uint64_t world_heights_bytes(const Sea& sea, int resolution);

}  // namespace ocean
