// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// spreading_row for many frequencies of one wave system: what depends on the direction alone is
// found once. For the table, which has some hundred rows of a thousand directions.
#pragma once

#include <span>
#include <vector>

#include "ocean/parameters.hpp"

namespace ocean {

class SpreadingRows {
  public:
    SpreadingRows(const WaveSystem& system, double wave_age_inverse, double mean_direction,
                  std::size_t columns);
    /// As spreading_row. x = omega / omega_p; row.size() is `columns`.
    void fill(double x, std::span<double> row) const;

  private:
    bool mixes_with_uniform() const { return system_.swell < 0.0; }

    WaveSystem system_;
    double wave_age_inverse_;
    // Of each direction theta about the mean.
    std::vector<double> shape_;       // what of the distribution does not depend on x
    std::vector<double> kept_;        // of the energy there: opposing, against the wind
    std::vector<double> log_cosine_;  // ln cos^2(theta/2)
    std::vector<double> distance_;    // |theta|
};

/// Sum of the values, in eight parts side by side.
double row_total(std::span<const double> row);

}  // namespace ocean
