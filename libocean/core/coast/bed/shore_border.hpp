// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The border of a bed: how waves of the open sea have been refracted when they reach it. The bed is
// not known outside. There it is assumed to continue as a plane beach with the contours' direction
// at the border; on such a beach waves obey Snell's law.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "bed_grid.hpp"

namespace ocean {

/// A vector in the plane of the sea: a direction, or a wave vector divided by the open sea's
/// wavenumber.
struct PlaneVector {
    double x = 0.0;
    double y = 0.0;

    double dot(PlaneVector other) const { return x * other.x + y * other.y; }
};

/// One side of a grid. Sample k of it, k < length, is sample (i + k di, j + k dj) of the grid, and
/// (di, dj) is +x or +y.
struct BorderSide {
    int i, j;
    int di, dj;
    int length;
    PlaneVector inward;
};

inline constexpr int kBorderSides = 4;

/// Returns the sides in the order west, east, south, north.
std::array<BorderSide, kBorderSides> border_sides(const Domain& domain);

/// Unit vectors along the border towards shallower water.
class BorderSlopes {
  public:
    /// Fits planes to the depth within 8 cells of each border sample. On a bed flatter than 1:10000
    /// the vectors point inward, so that contours follow the border.
    explicit BorderSlopes(const BedGrid& depth);

    const BorderSide& side(int s) const { return sides_[static_cast<std::size_t>(s)]; }
    PlaneVector upslope(int s, int k) const {
        return slopes_[static_cast<std::size_t>(s)][static_cast<std::size_t>(k)];
    }

  private:
    std::array<BorderSide, kBorderSides> sides_;
    std::array<std::vector<PlaneVector>, kBorderSides> slopes_;
};

/// Returns the wave vector, divided by the open sea's wavenumber, of a wave that had the given
/// direction in the open sea and has come over a plane beach to water of the given slowness >= 1.
/// The component along the contours stays as in the open sea, the other one completes the length
/// (Snell's law). A wave that runs towards deeper water by more than 12 degrees does not come over
/// such a beach and keeps its vector; between 0 and 12 degrees both are blended.
PlaneVector refracted(PlaneVector direction, double slowness, PlaneVector upslope);

}  // namespace ocean
