// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Heights at any place of a grid: the cubic B-spline through its samples, with its gradient, and
// the pyramid of such grids for coarser maps.
//
//   s(u, v) = sum c_ij B(u - i) B(v - j),   u, v in samples
//
// The coefficients c are the samples filtered by the inverse of (1 4 1)/6 along both axes, by a
// causal and an anticausal recursion with the pole sqrt(3) - 2 [Unser 1999]. A grid that wraps
// continues on its other side; one that exists once is mirrored about its outermost samples, and a
// place beyond them has the height of the nearest place on the edge. Test: land_function_test.cpp.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "ocean/domain.hpp"
#include "ocean/page_vector.hpp"
#include "ocean/thread_pool.hpp"

namespace ocean {

/// A height [m] and its slopes.
struct GroundJet {
    double height = 0.0;
    double slope_x = 0.0;
    double slope_y = 0.0;
};

class SplineGrid {
  public:
    /// Makes the spline through a row-major array of domain.count() finite samples.
    SplineGrid(const Domain& domain, std::span<const float> samples, ThreadPool& pool);

    const Domain& domain() const { return domain_; }
    /// Returns the value and its derivatives at a finite place [m], a function of the place alone.
    GroundJet at(double x, double y) const;
    /// Returns the value alone, with the bits of at().
    double value_at(double x, double y) const;
    /// Writes the values at places, with the bits of at(). Faster if neighbours have the same y.
    void values_at(std::span<const double> x, std::span<const double> y,
                   std::span<double> heights) const;
    static std::size_t bytes(const Domain& domain);

    struct InCell {
        std::size_t cell;  // whose lower end is at or below the coordinate
        double share;      // the coordinate in its cell, 0 .. 1
    };
    /// Returns the cell of a coordinate along an axis; beyond the ends of a domain that exists
    /// once, the end cell.
    InCell in_cell(double at, std::size_t axis) const;

  private:
    void filter_rows(std::span<const float> samples, ThreadPool& pool);
    void filter_columns(ThreadPool& pool);
    float* row(int j);

    Domain domain_;
    std::array<double, 2> per_metre_;
    std::size_t pitch_;  // length of a row, coefficients beyond both ends included
    PageVector<float> coefficients_;
};

/// Returns every other sample of a grid, from the first on, after the half-band filter (-1 0 9 16 9
/// 0 -1) / 32, which keeps waves of four new samples to within 2 % [Deslauriers and Dubuc 1989]. A
/// domain that wraps needs even counts of samples; one that exists once ends at its last even
/// sample.
std::vector<float> halved(const Domain& domain, std::span<const float> samples, ThreadPool& pool);
/// The reach of the filter on each side [samples].
inline constexpr int kHalvingReach = 3;
/// Returns every other sample unfiltered.
std::vector<float> decimated(const Domain& domain, std::span<const float> samples);
/// Returns the domain of every other sample.
Domain halved(const Domain& domain);

/// Splines of a grid and of its halved versions.
class SplinePyramid {
  public:
    /// Makes the levels down to about 16 samples along the shorter side. A map whose shortest wave
    /// has 2^(n + 1) samples is `oversampled` n times: n levels keep its samples unfiltered.
    SplinePyramid(const Domain& domain, std::span<const float> samples, ThreadPool& pool,
                  int oversampled = 0);

    /// Returns the level for maps whose samples lie `cell` apart [m]: the coarsest whose samples
    /// are no farther apart.
    const SplineGrid& level(double cell) const { return levels_[index(cell)]; }
    /// Returns the number of level(cell), from 0 for the finest.
    std::size_t index(double cell) const;
    const SplineGrid& at(std::size_t index) const { return levels_[index]; }
    std::size_t size() const { return levels_.size(); }
    const SplineGrid& finest() const { return levels_.front(); }
    static std::size_t bytes(const Domain& domain);

  private:
    std::vector<SplineGrid> levels_;
};

}  // namespace ocean
