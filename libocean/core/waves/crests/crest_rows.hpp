// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The rows of crests, which the waves must satisfy; each is a linear functional of the modes,
//   c = 2 Re sum h0 phi,   phi = g e^{i (k.x - omega t)},
// with g = 1 for the height, i k for the slopes, -i omega for the rise dh/dt and -i k coth(kd) /
// |k| for the horizontal displacement. Their covariances under the sea's spectrum are
//   G_mn = 2 Re sum P phi_m conj phi_n,   P = E|h0|^2.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "waves/crests/crest_waves.hpp"
#include "waves/crests/dependent_rows.hpp"

namespace ocean {

/// A place and a time.
struct CrestMoment {
    double x = 0.0;     // [m]
    double y = 0.0;     // [m]
    double time = 0.0;  // [s]
};

enum class CrestQuantity { height, slope_x, slope_y, rise, shift_x, shift_y };

struct CrestRow {
    CrestQuantity quantity = CrestQuantity::height;
    std::size_t moment = 0;
};

/// Rows, and the moments at which they stand.
struct CrestRows {
    std::vector<CrestMoment> moments;
    std::vector<CrestRow> rows;

    void add(std::span<const CrestQuantity> quantities, const CrestMoment& moment);
};

/// The functionals of one wave: phi of each row.
class CrestFunctionals {
  public:
    CrestFunctionals(const CrestRows& rows, const Modes& modes);

    void set_wave(const CrestWave& wave);
    std::span<const double> real() const { return real_; }
    std::span<const double> imaginary() const { return imaginary_; }

  private:
    const CrestRows& rows_;
    std::vector<double> tau_;  // Modes::tau of each moment
    std::vector<double> cosine_, sine_;
    std::vector<double> real_, imaginary_;
};

/// Sums over one part of the waves.
struct RowSums {
    Gram gram;                // covariances of the rows
    std::vector<double> now;  // their values
};
/// Returns the sums of rows. weight: the share of a wave's variance that counts.
RowSums sums_of(const CrestRows& rows, const CrestWaves& waves,
                const std::function<double(const CrestWave&)>& weight);

/// Sums over the long waves, weighted for one crest: where its way goes and how long it is.
struct CrestMeans {
    double m0 = 0.0;  // sum P
    double k = 0.0;
    double omega = 0.0;
    double east = 0.0, north = 0.0;       // sum P k / |k|
    double omega_x = 0.0, omega_y = 0.0;  // sum P omega k
    double xx = 0.0, xy = 0.0, yy = 0.0;  // sum P k k

    void add(const CrestWave& wave, double weight);
    CrestMeans& operator+=(const CrestMeans& other);
};

/// Returns the share of a wave's variance that carries a crest: 1, or for a crest with a direction
/// cos^2 of the angle to it, 0 for waves that travel against it.
double crest_weight(const Crest& crest, const CrestWave& wave);

/// Returns the neighbours of a crest that keep it the highest point: places on two circles around
/// it, and around where the crest itself is some tenths of a period earlier and later.
std::vector<CrestMoment> crest_neighbours(const CrestMoment& crest, const CrestMeans& means);

}  // namespace ocean
