// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Cells round random points on a periodic square: bubbles and the holes of foam.
#pragma once

#include <cstdint>
#include <vector>

namespace ocean {

/// count^2 points, one at a random place in each cell of a square lattice. Lengths are in cells.
class FoamCells {
  public:
    /// Draws the points. spread: the spread of the cells' sizes; a point of weight w counts as
    /// nearer by w, 0 <= w < spread.
    FoamCells(std::uint32_t seed, std::uint32_t field, int count, float spread);
    int count() const { return count_; }

    /// Distances to the nearest point and to the second nearest, minus their weights. Both are
    /// equal on the walls between cells [Worley 1996].
    struct Distances {
        float first, second;
    };
    /// 0 <= x, y <= count, or at most kReach outside.
    static constexpr float kReach = 2.0f;
    Distances at(float x, float y) const;

  private:
    struct Point {
        float x, y, weight;
    };
    Point point(std::uint32_t seed, std::uint32_t field, int i, int j) const;

    int count_;
    int width_;  // points in a row, neighbouring periods included
    float spread_;
    std::vector<Point> points_;
};

}  // namespace ocean
