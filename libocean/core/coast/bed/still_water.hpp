// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The water of a bed that no wave of the open sea can reach: ponds behind dikes, lagoons behind
// dunes, the sea behind land that lies across the whole bed.
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
    /// For each sample of the bed 1 where it is still: water that is shut off, and the land that
    /// is nearer to such water than to any other. Empty if none is.
    std::vector<std::uint8_t> still;

    bool is_still(std::size_t sample) const { return !still.empty() && still[sample] != 0; }
};

/// Finds the water that waves which come in from `directions` [rad] do not reach. They come in by
/// the sides of the bed that they cross inward. The bed goes on beyond its sides as it is there,
/// for its own longer side; a wave that would have crossed land there does not come in.
StillWater find_still_water(const BedGrid& bed_height, std::span<const double> directions);

/// Returns the index of the sample that is nearest to a place [m], beyond the border of the border.
std::size_t nearest_sample(const Domain& domain, const std::array<double, 2>& place);

}  // namespace ocean
