// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The water of a bed that no wave of the open sea can reach: ponds behind dikes, lagoons behind
// dunes, the sea behind land that crosses the whole bed.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "bed_grid.hpp"

namespace ocean {

/// Returns the share of the energy that a bed of this height [m] lets pass: 1 below -0.15 m, 0
/// above 0.15 m.
float passing(double height);

/// A sample is land where its height lets no energy pass. Water is joined by the sides of samples,
/// land by their corners too, so that an oblique wall of one sample is closed.
struct StillWater {
    /// For each sample of the bed, 1 if it is still: shut-off water, and land that is nearer to
    /// such water than to any other. Empty if no water is shut off.
    std::vector<std::uint8_t> still;

    bool is_still(std::size_t sample) const { return !still.empty() && still[sample] != 0; }
};

/// Finds the water that waves from `directions` [rad] do not reach. Waves enter by the sides of the
/// bed that they cross inward. Beyond each side the bed is assumed to continue with the side's
/// heights for the length of the longer side; a wave that would have crossed land there does not
/// enter.
StillWater find_still_water(const BedGrid& bed_height, std::span<const double> directions);

/// Returns the index of the sample that is nearest to a place [m]; beyond the border, of the
/// nearest border sample.
std::size_t nearest_sample(const Domain& domain, const std::array<double, 2>& place);

}  // namespace ocean
