// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// spreading_row for many frequencies of one wave system: the part that depends on the direction
// alone is computed once. The table has some hundred rows of a thousand directions.
#pragma once

#include <span>
#include <vector>

#include "ocean/parameters.hpp"

namespace ocean {

class SpreadingRows {
  public:
    SpreadingRows(const WaveSystem& system, double wave_age_inverse, double mean_direction,
                  std::size_t columns);
    /// Fills a row as spreading_row does. x = omega / omega_p; row.size() is `columns`.
    void fill(double x, std::span<double> row) const;

  private:
    bool mixes_with_uniform() const { return system_.swell < 0.0; }

    WaveSystem system_;
    double wave_age_inverse_;
    // One for each direction theta about the mean:
    std::vector<double> shape_;       // the part of the distribution that does not depend on x
    std::vector<double> kept_;        // the share of energy kept there: opposing, against the wind
    std::vector<double> log_cosine_;  // ln cos^2(theta/2)
    std::vector<double> distance_;    // |theta|

    std::vector<double> same_everywhere_;  // the row of every x; empty if rows differ
};

/// Returns the sum of the values, in eight parts side by side.
double row_total(std::span<const double> row);

}  // namespace ocean
