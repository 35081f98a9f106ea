// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Sums over rows of modes while their amplitudes are made: the covariance of the gradients of each
// shell max(|n|, |m|) = s, and the variance that measures a band.
#pragma once

#include <cmath>
#include <span>
#include <vector>

#include "modes/quadrant_variances.hpp"
#include "ocean/modes.hpp"

namespace ocean {

class ShellSums {
  public:
    /// Nothing is summed yet; N/2 shells.
    void start(int shells) {
        shells_.assign(static_cast<std::size_t>(shells), {});
        measured_ = 0.0;
    }

    /// The modes (+-n, m) and (+-n, -m), n < end, with their displacements [m].
    void add(const Lattice& lattice, int m, int end, const QuadrantVariances& variances,
             std::span<const float> displacement) {
        const auto& v = variances.quarter;
        const double step = lattice.wavenumber_step();
        const double ky = step * m;
        const auto add_modes = [&](std::size_t n, GradientCovariance& sum) {
            const double kx = step * static_cast<double>(n);
            const double square = static_cast<double>(displacement[n]) * displacement[n];
            const double all = square * (v[0][n] + v[1][n] + v[2][n] + v[3][n]);
            const double skew = square * (v[0][n] - v[1][n] + v[2][n] - v[3][n]) * kx * ky;
            sum.aa += all * (kx * kx) * (kx * kx);
            sum.bb += all * (ky * ky) * (ky * ky);
            sum.ab += all * (kx * kx) * (ky * ky);
            sum.ac += skew * (kx * kx);
            sum.bc += skew * (ky * ky);
        };
        const auto row = static_cast<std::size_t>(m);
        const auto last = static_cast<std::size_t>(end);
        GradientCovariance own;
        for (std::size_t n = 0; n <= row && n < last; ++n) add_modes(n, own);
        shells_[row] += own;
        for (std::size_t n = row + 1; n < last; ++n) add_modes(n, shells_[n]);
        // As measures_band: inside the circle of the Nyquist line.
        const std::size_t half = v[0].size();
        for (std::size_t n = 0; n < last && n * n + row * row < half * half; ++n) {
            measured_ += variances.sum(n);
        }
    }

    void add(const ShellSums& other) {
        measured_ += other.measured_;
        for (std::size_t s = 0; s < shells_.size(); ++s) shells_[s] += other.shells_[s];
    }

    double measured() const { return measured_; }
    GradientCovariance covariance(std::size_t s) const {
        GradientCovariance covariance = shells_[s];
        covariance.cc = covariance.ab;  // c^2 = kx^2 ky^2 (coth(kd) / k)^2 = a b
        return covariance;
    }

  private:
    double measured_ = 0.0;  // variance, m^2
    std::vector<GradientCovariance> shells_;
};

}  // namespace ocean
