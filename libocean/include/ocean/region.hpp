// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Regions: rectangles that a user cuts out of a land or a coast, which are functions of the place.
#pragma once

#include <array>

#include "ocean/domain.hpp"

namespace ocean {

inline constexpr int kMaxRegionSide = 32768;

/// A rectangle at any place, with samples `cell` apart; its far sides lie at the last samples
/// within the size.
struct Region {
    std::array<double, 2> origin{};  // [m]
    std::array<double, 2> size{};    // [m]
    double cell = 1.0;               // [m]
};

/// Returns the samples of a region. Throws Error invalid_value unless it has 2 .. kMaxRegionSide
/// samples along each side.
Domain domain_of(const Region& region);

/// Returns the rectangle of a domain that exists once, with samples `cell` apart [m] both ways:
/// from its origin as many samples as lie within the domain, at least 2 along each side.
Domain with_cell(Domain domain, double cell);

}  // namespace ocean
