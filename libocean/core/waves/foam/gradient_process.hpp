// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The water at one label over time, without a map: the gradients of the displacement as a Gaussian
// process.
#pragma once

#include <array>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "ocean/internal/fft.hpp"
#include "ocean/internal/foam.hpp"
#include "ocean/internal/modes.hpp"
#include "waves/foam/jacobian_nodes.hpp"

namespace ocean {

/// A closed stretch of a label's life: the loop, or many times the time for which foam counts.
struct Stretch {
    int ticks;       // a power of two
    double seconds;  // of all ticks together
    int reach;       // ticks after which a power of faded foam is negligible

    double step() const { return seconds / ticks; }
};

/// Returns the stretch for a lifetime of foam [s].
Stretch stretch_of(const FoamClock& clock, double lifetime);

/// The gradients of the displacement at a label, along two axes: a and b along them, c across.
struct Gradients {
    double a, b, c;
};
inline Gradients operator+(const Gradients& g, const Gradients& h) {
    return {g.a + h.a, g.b + h.b, g.c + h.c};
}

/// The waves that a map of one resolution holds but a coarser map does not.
struct WaveBand {
    int held_by;
    int not_by = 0;  // resolution of the coarser map; 0: none
};

/// The gradients at a label over a stretch of time: a stationary Gaussian process, each wave of
/// which moves a, b and c in step.
class GradientProcess {
  public:
    /// Makes the process of the waves of `band` along axes turned by `angle` [radians] from +x.
    /// `covariance` belongs to the modes of these waves, and may differ slightly from the integral.
    GradientProcess(const FoamSea& sea, const WaveBand& band, const GradientCovariance& covariance,
                    double angle, const Stretch& stretch);

    /// Returns the covariance of the gradients at one time.
    const GradientCovariance& covariance() const { return covariance_; }

    /// Returns two practically independent stretches, from the noise of `number`. Processes of
    /// different `part`s (0, 1) are independent of each other.
    std::array<std::vector<Gradients>, 2> draw(std::uint32_t number, int part = 0) const;

    /// Conditions a stretch on the gradients `at` at a tick: writes the part from `reach` ticks
    /// before to `reach` ticks after it, x(t) + R(t - s) R(0)^-1 (at - x(s)).
    void passing(const Gradients& at, std::size_t tick, int reach,
                 std::span<const Gradients> stretch, std::vector<Gradients>& window) const;

  private:
    /// Returns the sum over the bins at each tick.
    std::vector<std::complex<double>> transformed(std::vector<std::complex<double>> bins) const;

    Radix2Fft<double> fft_;
    GradientCovariance covariance_;
    GradientFactors still_{{}};             // of covariance_
    std::vector<GradientFactors> factors_;  // of each bin
    std::vector<GradientCovariance> lags_;  // [tick]: covariance of the gradients over this lag
};

}  // namespace ocean
