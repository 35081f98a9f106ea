// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Sampling of the spectrum table for modes: one frequency in the four directions that are mirror
// images of each other in the axes. It is the stage between the table and the modes, rebuilt for
// each table.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

#include "ocean/internal/directional_spectrum.hpp"
#include "waves/modes/mode_rows_task.hpp"

namespace ocean {

/// DirectionalSpectrum::density, to rounding. The spectrum must outlive it.
class QuadrantSampler {
  public:
    explicit QuadrantSampler(const DirectionalSpectrum& spectrum)
        : omega_(spectrum.angular_frequencies()),
          table_(spectrum.table().data()),
          directions_(spectrum.directions()) {
        if (spectrum.flat()) return;
        for (std::size_t i = 0; i + 1 < omega_.size(); ++i) {
            inverse_gap_.push_back(1.0 / (omega_[i + 1] - omega_[i]));
        }
        first_bucket_ = bucket(omega_.front());
        std::uint32_t row = 0;
        for (std::uint64_t b = first_bucket_; b <= bucket(omega_.back()); ++b) {
            const auto edge = std::bit_cast<double>(b << QuadrantTable::kDroppedBits);
            while (row + 2 < omega_.size() && omega_[row + 1] <= edge) ++row;
            row_of_bucket_.push_back(row);
        }
    }

    /// Writes for each cell the sums of weight times density, in the order of QuadrantVariances.
    void write_variances(const QuadrantCells& cells, double* const (&variances)[4],
                         SimdLevel level = simd_level()) const {
        if (omega_.empty()) {
            for (double* const quarter : variances) std::fill_n(quarter, cells.count, 0.0);
            return;
        }
        const QuadrantTable table{.omega = omega_.data(),
                                  .inverse_gap = inverse_gap_.data(),
                                  .lowest = omega_.front(),
                                  .highest = omega_.back(),
                                  .directions = static_cast<double>(directions_),
                                  .density = table_,
                                  .row_size = DirectionalSpectrum::row_size(directions_),
                                  .first_bucket = first_bucket_,
                                  .row_of_bucket = row_of_bucket_.data()};
        mode_row_loops(level).variances(table, cells, variances);
    }

  private:
    static std::uint64_t bucket(double omega) {
        return std::bit_cast<std::uint64_t>(omega) >> QuadrantTable::kDroppedBits;
    }

    std::span<const double> omega_;
    const double* table_;
    int directions_;
    std::vector<double> inverse_gap_;
    std::uint64_t first_bucket_ = 0;
    std::vector<std::uint32_t> row_of_bucket_;
};

}  // namespace ocean
