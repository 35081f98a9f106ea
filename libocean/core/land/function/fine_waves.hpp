// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Waves below the samples of a land, at any place and without repetition: small tiles that are read
// with hashed shifts, turns and signs.
//
//   h(x) = sum w_i s_i t(T_i x) / sqrt(sum w_i^2),   w = (1 - r^2 / R^2)^3 for r < R
//
// i are the vertices of a triangular lattice of spacing a = 3 longest waves, r the distance from x,
// R = 0.85 a; s_i is a sign, T_i a turn and a shift, hashed from i, and t is a tile. The tiles read
// at a place are independent, so that the variance is the tile's everywhere [Heitz and Neyret
// 2018]; the weights are C2. A tile has exactly the energy of the density in each third of an
// octave, because its random deviations would show everywhere. Extra variance of slopes by the
// weights: 0.2 %. Test: land_function_test.cpp.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "field/spline_grid.hpp"

namespace ocean {

/// A density over (kx, ky) [m^4] that does not depend on the direction, as a function of k [rad/m].
using RadialDensity = std::function<double(double k)>;

class FineWaves {
  public:
    /// Makes tiles of the waves from `longest` to `shortest` [m], shortest < longest. The longest
    /// wave of a tile is at most kMaxRatio times its shortest.
    FineWaves(const RadialDensity& density, double longest, double shortest, std::uint32_t seed,
              ThreadPool& pool);

    /// Returns the sum of the waves at a place, for maps whose samples lie `cell` apart [m]: waves
    /// below two cells fade out. The result depends on the arguments alone.
    GroundJet at(double x, double y, double cell) const;
    /// Returns the mean of the square of the heights [m^2].
    double variance() const { return variance_; }
    /// Returns the bytes of the tiles for these waves.
    static std::uint64_t bytes(double longest, double shortest);

    static constexpr double kMaxRatio = 64.0;

  private:
    struct Tile {
        SplinePyramid samples;
        double period;   // [m]
        double spacing;  // of the lattice of readings [m]
        double longest;  // [m]
        std::uint32_t seed;
    };
    static GroundJet read(const Tile& tile, double x, double y, double cell);

    std::vector<Tile> tiles_;
    double variance_ = 0.0;
};

/// Returns the density as a table from k0 to k1 [rad/m], straight lines over log k, 64 to an
/// octave; 0 beyond. Tiles read the density of each of their waves.
RadialDensity tabulated(const RadialDensity& density, double k0, double k1);
/// Returns the integral of the density over the ring of k0 .. k1 [rad/m]: a variance [m^2].
double ring_variance(const RadialDensity& density, double k0, double k1);

}  // namespace ocean
