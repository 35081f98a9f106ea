// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The phase of refracted waves by the eikonal equation |grad phi| = s, where the slowness s is the
// wavenumber divided by the open sea's. It is solved for the delay tau = phi - c . x against the
// open sea's wave, because the delay is a small difference of large phases.
#pragma once

#include <span>
#include <vector>

#include "coast/bed/shore_border.hpp"
#include "field/grid_lines.hpp"

namespace ocean {

/// Solves the eikonal equation on one grid for many waves; keeps its memory between them. One
/// thread at a time. Lengths are in cells.
class EikonalSolver {
  public:
    /// Beaches need 2 sweeps, islands 9, the longest waves over a rough bed up to 38; late sweeps
    /// cost little.
    static constexpr int kMaxSweeps = 40;
    /// Changes of a delay up to this are ignored [cells]. Rounding stays far below, and at k = 2
    /// rad/m and cells of 4 m this is a phase of 1e-5 rad.
    static constexpr double kTolerance = 1e-6;

    EikonalSolver(const SampleGrid& grid, const BorderSlopes& border);

    /// Solves for a wave that travels along the unit vector `direction` in the open sea. slowness:
    /// row-major, >= 1. Solves twice: the directions of the first solve improve the order of the
    /// second. Each solve stops after max_sweeps, or after a sweep that changes nothing. Returns
    /// the number of sweeps of the second solve.
    int solve(std::span<const float> slowness, PlaneVector direction, int max_sweeps = kMaxSweeps);

    /// Returns the delay of the last wave at a sample [cells]: exactly 0 where the wave is the open
    /// sea's.
    double delay(int i, int j) const {
        const double tau = delays_[padded(i, j)];
        return tau > kRounding || tau < -kRounding ? tau : 0.0;
    }

  private:
    static constexpr double kRounding = 1e-9;  // [cells]

    std::size_t padded(int i, int j) const {
        return static_cast<std::size_t>(j + 1) * stride_ + static_cast<std::size_t>(i + 1);
    }
    /// Returns the slowness at a sample of a side.
    double slowness_at(std::span<const float> slowness, const BorderSide& side, int k) const {
        return double{slowness[grid_.index(side.i + k * side.di, side.j + k * side.dj)]};
    }

    int sweep(std::span<const float> slowness, int max_sweeps);
    void refine_slowness(std::span<const float> slowness);
    void enter(std::span<const float> slowness);
    void enter_side(std::span<const float> slowness, int s, int from, double delay);
    void note_slant(std::span<const float> slowness, int s);
    bool follow_side(int s);
    template <int kStep>
    bool sweep_row(int j);
    void mark_row(int j);

    SampleGrid grid_;
    const BorderSlopes& border_;
    std::size_t stride_;
    PlaneVector direction_;
    std::vector<double> delays_;  // with a ring of samples around the grid that no wave reaches
    /// Per row: false if its last visit changed nothing and no neighbouring row has changed since,
    /// so that another visit would change nothing.
    std::vector<char> stale_;
    std::vector<float> upwind_;  // slowness between a sample and its upwind neighbours
    /// Per side: the tangential component of the wave vector, where waves enter although the
    /// direction of the open sea does not point inward; else empty.
    std::array<std::vector<float>, kBorderSides> slant_;
};

}  // namespace ocean
