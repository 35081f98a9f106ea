// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Heights by world position instead of by label, for formats without overhangs: the displacement is
// inverted, and where the surface folds the top sheet counts.
#pragma once

#include <cstdint>

#include "ocean/ocean.hpp"
#include "ocean/subject.hpp"

namespace ocean {

/// Returns the heights on resolution^2 positions of the period. Throws as Ocean::query.
WorldHeights world_heights(Ocean& ocean, double time, int resolution);
/// Returns an upper bound of the bytes that world_heights needs beside the surface; 0 for a sea
/// whose choppiness is always 0.
std::uint64_t world_heights_bytes(const Sea& sea, int resolution);

/// Returns the heights of a sea over a bed on the positions of a domain that does not wrap. Throws
/// as Ocean::region.
WorldHeights region_heights(Ocean& ocean, double time, const Domain& domain);
/// Returns the bytes that region_heights needs beside the surface.
std::uint64_t region_heights_bytes(const Domain& domain);

}  // namespace ocean
