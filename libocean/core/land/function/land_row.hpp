// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A row of places of a land, and the sum of its parts there.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "land/function/land_function_parts.hpp"

namespace ocean {

inline constexpr ChannelSet kSlopes = {Channel::slope_x, Channel::slope_y, Channel::nx, Channel::ny,
                                       Channel::nz};

/// Masks that gullies make.
inline constexpr std::array kGullyMasks = {LandMask::wear, LandMask::gully, LandMask::ridge};

struct LandRow {
    std::vector<double> x, y;
    std::vector<double> height, slope_x, slope_y;
    std::vector<float> part_height, part_x, part_y;  // the gullies' own
    std::array<std::vector<float>, kGullyMasks.size()> masks;

    void resize(std::size_t n) {
        for (auto* values : {&x, &y, &height, &slope_x, &slope_y}) values->resize(n);
    }
    std::size_t size() const { return x.size(); }
};

/// Computes the heights at the places of a row, for maps whose samples lie `cell` apart [m]; also
/// masks of gullies, and exact slopes of a land without gullies, if channels of `wanted` need them.
/// Heights have the same bits with and without these.
void compute(const LandFunctionParts& parts, double cell, ChannelSet wanted, LandRow& row);

}  // namespace ocean
