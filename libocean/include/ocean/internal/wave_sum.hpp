// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The sea at single points: every mode summed in double precision, without maps and interpolation.
// Slow and exact: the reference for queries, and the source of gauge readings.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "ocean/internal/modes.hpp"
#include "ocean/parameters.hpp"
#include "ocean/query.hpp"

namespace ocean {

/// The linear fields of one label, as a map holds them at its samples. D is the horizontal
/// displacement: the point is displayed at (x - C Dx, y - C Dy, height), C = choppiness.
struct LinearSample {
    double height;                                    // [m]
    double displacement_x, displacement_y;            // [m]
    double slope_x, slope_y;                          // dh/dx, dh/dy
    double gradient_xx, gradient_yy, gradient_xy;     // dDx/dx, dDy/dy, dDx/dy
    double height_rate;                               // [m/s]
    double displacement_x_rate, displacement_y_rate;  // [m/s]
};

/// The displaced position of a label with its derivatives: all that inverting the displacement
/// needs, at half the cost of a LinearSample.
struct DisplacementSample {
    double displacement_x, displacement_y;         // [m]
    double gradient_xx, gradient_yy, gradient_xy;  // dDx/dx, dDy/dy, dDx/dy
};

/// The factor by which each mode decays to one depth, for a WaveSum and its copies.
class WaterLevel {
  private:
    friend class WaveSum;
    std::vector<double> along_;  // cosh k(z + d) / (k sinh kd) [m]
    std::vector<double> up_;     // sinh k(z + d) / sinh kd
};

/// The angle by which each mode turns in a fixed time dt, for a WaveSum and its copies.
class WaveStep {
  private:
    friend class WaveSum;
    std::vector<double> cosine_;      // cos(omega dt)
    std::vector<double> sine_over_;   // sin(omega dt) / omega [s]
    std::vector<double> sine_times_;  // sin(omega dt) * omega [rad/s]
};

/// The modes of one time. Immutable except for set_time and advance; several threads may evaluate
/// one WaveSum at once. Copies share everything that does not change with time, so that a copy for
/// each thread is cheap.
class WaveSum {
  public:
    /// Leaves out the modes above the Nyquist line of a map of `resolution` samples; 0 keeps all.
    /// Keeps no reference to its arguments. The time is 0.
    WaveSum(const Modes& modes, const Water& water, int resolution = 0);
    void set_time(double time);
    /// Advances the time by the time of a step, ten times as fast as set_time. Each step adds a
    /// rounding error of a double: call set_time again after some hundreds.
    void advance(const WaveStep& step);
    /// Returns the step of a fixed time [s].
    WaveStep wave_step(double seconds) const;

    /// Returns all linear fields at the label (x, y) [m].
    LinearSample at_label(double x, double y) const;
    /// Returns the displacement at the label (x, y) [m].
    DisplacementSample displacement_at(double x, double y) const;

    /// Returns the rms of |D| over all labels and times [m].
    double displacement_rms() const;

    /// Returns the motion at the fixed point (x, y, z) [m], z up from still water. It decays with
    /// depth as cosh k(z + d) / sinh kd. Above z = 0 it equals the motion at z = 0; below the
    /// bottom it is 0.
    WaterMotion water_motion(double x, double y, double z) const;
    /// Returns the motion at a level, which saves the exponentials for many points or times at one
    /// z.
    WaterMotion water_motion(double x, double y, const WaterLevel& level) const;
    /// Returns the level of a height z [m] up from still water.
    WaterLevel water_level(double z) const;

    /// Returns an upper bound of the bytes of that many copies, levels and steps.
    static std::uint64_t bytes(const Modes& modes, std::size_t copies, std::size_t levels = 0,
                               std::size_t steps = 0);

  private:
    struct Fixed;
    struct Waves;

    template <int kSums, typename Term, typename Row>
    void sweep(double x, double y, const Term& term, const Row& row) const;

    std::shared_ptr<const Fixed> fixed_;
    // 2 h(k, t) and 2 dh/dt of each mode that stands for k and -k [m], [m/s].
    std::vector<double> re_, im_, rate_re_, rate_im_;
};

}  // namespace ocean
