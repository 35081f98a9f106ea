// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Sampling of the spectrum table for modes: one frequency in the four directions that are mirror
// images of each other in the axes. It is the stage between the table and the modes, rebuilt for
// each table.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "ocean/internal/directional_spectrum.hpp"

namespace ocean {

/// DirectionalSpectrum::density, to rounding. The spectrum must outlive it.
class QuadrantSampler {
  public:
    explicit QuadrantSampler(const DirectionalSpectrum& spectrum)
        : omega_(spectrum.angular_frequencies()),
          table_(spectrum.table().data()),
          directions_(static_cast<std::size_t>(spectrum.directions())) {
        if (spectrum.flat()) return;
        for (std::size_t i = 0; i + 1 < omega_.size(); ++i) {
            inverse_gap_.push_back(1.0 / (omega_[i + 1] - omega_[i]));
        }
        first_bucket_ = bucket(omega_.front());
        std::uint32_t row = 0;
        for (std::uint64_t b = first_bucket_; b <= bucket(omega_.back()); ++b) {
            const auto edge = std::bit_cast<double>(b << kDroppedBits);
            while (row + 2 < omega_.size() && omega_[row + 1] <= edge) ++row;
            row_of_bucket_.push_back(row);
        }
    }

    /// Returns densities towards theta, pi - theta, pi + theta and -theta; theta in turns, 0 ..
    /// 1/4.
    std::array<double, 4> density(double omega, double theta) const {
        if (omega_.empty() || !(omega >= omega_.front() && omega < omega_.back())) return {};
        std::size_t row = row_of_bucket_[bucket(omega) - first_bucket_];
        while (omega >= omega_[row + 1]) ++row;
        const double v = (omega - omega_[row]) * inverse_gap_[row];
        const double column = theta * static_cast<double>(directions_);
        const auto j = static_cast<std::size_t>(static_cast<std::int64_t>(column));
        const double u = column - static_cast<double>(j);

        const double* low = table_ + row * directions_;
        const double* high = low + directions_;
        const auto at = [=](std::size_t near, std::size_t far) {
            const double here = low[near] + v * (high[near] - low[near]);
            const double next = low[far] + v * (high[far] - low[far]);
            return here + u * (next - here);
        };
        const std::size_t half = directions_ / 2;
        const std::size_t mirror = j == 0 ? 0 : directions_ - j;
        return {at(j, j + 1), at(half - j, half - j - 1), at(half + j, half + j + 1),
                at(mirror, directions_ - j - 1)};
    }

  private:
    // The leading bits of a positive double rise with it, 1024 steps to the octave: about as close
    // as the closest rows of a table.
    static constexpr int kDroppedBits = 42;
    static std::uint64_t bucket(double omega) {
        return std::bit_cast<std::uint64_t>(omega) >> kDroppedBits;
    }

    std::span<const double> omega_;
    const double* table_;
    std::size_t directions_;
    std::vector<double> inverse_gap_;
    std::uint64_t first_bucket_ = 0;
    std::vector<std::uint32_t> row_of_bucket_;  // a row at or before the bucket's first row
};

}  // namespace ocean
