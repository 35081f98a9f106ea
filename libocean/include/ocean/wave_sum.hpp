// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The sea at single points: every mode added up, in double precision, no map and no interpolation.
// Slow and exact: the judge of queries, and what gauges read.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "ocean/modes.hpp"
#include "ocean/parameters.hpp"

namespace ocean {

/// The linear fields of one label, as a map holds them at its samples. D is the horizontal
/// displacement: the point is shown at (x - C Dx, y - C Dy, height), C = choppiness.
struct LinearSample {
    double height;                                    // m
    double displacement_x, displacement_y;            // m
    double slope_x, slope_y;                          // dh/dx, dh/dy
    double gradient_xx, gradient_yy, gradient_xy;     // dDx/dx, dDy/dy, dDx/dy
    double height_rate;                               // m/s
    double displacement_x_rate, displacement_y_rate;  // m/s
};

/// Where a label is shown, all that inverting the displacement needs: half the work of a
/// LinearSample.
struct DisplacementSample {
    double displacement_x, displacement_y;         // m
    double gradient_xx, gradient_yy, gradient_xy;  // dDx/dx, dDy/dy, dDx/dy
};

/// What moves in the water at a fixed place, by linear theory.
struct WaterMotion {
    double velocity_x, velocity_y, velocity_z;  // m/s
    double pressure;                            // Pa, without the hydrostatic part

    bool operator==(const WaterMotion&) const = default;
};

/// How much of each mode is left at one depth, for a WaveSum and its copies.
class WaterLevel {
  private:
    friend class WaveSum;
    std::vector<double> along_;  // cosh k(z + d) / (k sinh kd), m
    std::vector<double> up_;     // sinh k(z + d) / sinh kd
};

/// How far each mode turns in a fixed time, for a WaveSum and its copies.
class WaveStep {
  private:
    friend class WaveSum;
    std::vector<double> cosine_;      // of omega dt
    std::vector<double> sine_over_;   // over omega, s
    std::vector<double> sine_times_;  // times omega, rad/s
};

/// The modes of one time. Immutable but for set_time and advance; several threads may ask at once.
/// Copies share what does not change with time: one for each thread is cheap.
class WaveSum {
  public:
    /// Modes above the Nyquist line of a map of `resolution` samples are left out; 0 keeps all.
    /// Keeps no reference. The time is 0.
    WaveSum(const Modes& modes, const Water& water, int resolution = 0);
    void set_time(double time);
    /// On by the time of a step, ten times as fast as set_time. Each step adds a rounding error of
    /// a double: set the time again after some hundreds.
    void advance(const WaveStep& step);
    WaveStep wave_step(double seconds) const;

    /// At the label (x, y), m.
    LinearSample at_label(double x, double y) const;
    DisplacementSample displacement_at(double x, double y) const;

    /// rms of |D| over all labels and times, m.
    double displacement_rms() const;

    /// At the fixed point (x, y, z), z up from still water. Decays as cosh k(z + d) / sinh kd;
    /// above z = 0 as at z = 0, below the bottom nothing.
    WaterMotion water_motion(double x, double y, double z) const;
    /// The same for many points or times at one z, without its exponentials.
    WaterMotion water_motion(double x, double y, const WaterLevel& level) const;
    WaterLevel water_level(double z) const;

    /// Bytes of so many copies, levels and steps, at most.
    static std::uint64_t bytes(const Modes& modes, std::size_t copies, std::size_t levels = 0,
                               std::size_t steps = 0);

  private:
    struct Fixed;
    struct Waves;

    template <int kSums, typename Term, typename Row>
    void sweep(double x, double y, const Term& term, const Row& row) const;

    std::shared_ptr<const Fixed> fixed_;
    // 2 h(k, t) and 2 dh/dt of each mode that stands for k and -k, m and m/s.
    std::vector<double> re_, im_, rate_re_, rate_im_;
};

}  // namespace ocean
