// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Statistics of heights: see relief.hpp.
#include "relief.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "ocean/internal/grid.hpp"

namespace ocean {
namespace {

constexpr double kDegrees = 180.0 / kPi;

/// Heights above their least-squares plane.
class LevelledHeights {
  public:
    LevelledHeights(const Domain& domain, std::span<const float> heights)
        : heights_(heights), columns_(domain.samples[0]), rows_(domain.samples[1]) {
        double xx = 0.0, yy = 0.0;
        for (int j = 0; j < rows_; ++j) {
            for (int i = 0; i < columns_; ++i) {
                const double h = height(i, j), x = i - 0.5 * (columns_ - 1),
                             y = j - 0.5 * (rows_ - 1);
                mean_ += h;
                slope_x_ += x * h;
                slope_y_ += y * h;
                xx += x * x;
                yy += y * y;
            }
        }
        mean_ /= static_cast<double>(heights.size());
        slope_x_ /= xx;
        slope_y_ /= yy;
    }

    double height(int i, int j) const {
        return double{heights_[static_cast<std::size_t>(j) * static_cast<std::size_t>(columns_) +
                               static_cast<std::size_t>(i)]};
    }
    double above_mean(int i, int j) const { return height(i, j) - mean_; }
    double above_plane(int i, int j) const {
        return above_mean(i, j) - slope_x_ * (i - 0.5 * (columns_ - 1)) -
               slope_y_ * (j - 0.5 * (rows_ - 1));
    }

  private:
    std::span<const float> heights_;
    int columns_;
    int rows_;
    double mean_ = 0.0;
    double slope_x_ = 0.0;  // [m per sample]
    double slope_y_ = 0.0;
};

}  // namespace

Relief relief_of(const Domain& domain, std::span<const float> heights) {
    const LevelledHeights land(domain, heights);
    Relief relief;
    double squares = 0.0, cubes = 0.0, squares_about_mean = 0.0;
    double xx = 0.0, xy = 0.0, yy = 0.0;
    std::vector<float> slopes;
    for (int j = 0; j < domain.samples[1]; ++j) {
        for (int i = 0; i < domain.samples[0]; ++i) {
            const double h = land.above_plane(i, j);
            squares += h * h;
            cubes += h * h * h;
            squares_about_mean += land.above_mean(i, j) * land.above_mean(i, j);
            const bool inside =
                i > 0 && j > 0 && i + 1 < domain.samples[0] && j + 1 < domain.samples[1];
            if (!inside) continue;
            const double sx =
                (land.height(i + 1, j) - land.height(i - 1, j)) / (2.0 * domain.step(0));
            const double sy =
                (land.height(i, j + 1) - land.height(i, j - 1)) / (2.0 * domain.step(1));
            xx += sx * sx;
            xy += sx * sy;
            yy += sy * sy;
            slopes.push_back(static_cast<float>(std::hypot(sx, sy)));
        }
    }
    const double count = static_cast<double>(heights.size());
    relief.rms = std::sqrt(squares / count);
    relief.rms_about_mean = std::sqrt(squares_about_mean / count);
    if (relief.rms > 0.0) relief.skewness = cubes / count / std::pow(relief.rms, 3);
    for (std::size_t n = 0; n < kReliefShares.size(); ++n) {
        const auto at =
            static_cast<std::ptrdiff_t>(kReliefShares[n] * static_cast<double>(slopes.size() - 1));
        std::ranges::nth_element(slopes, slopes.begin() + at);
        relief.slopes[n] = std::atan(double{slopes[static_cast<std::size_t>(at)]}) * kDegrees;
    }
    // The principal axes of the mean square slope.
    const double middle = 0.5 * (xx + yy), turn = std::hypot(0.5 * (xx - yy), xy);
    relief.anisotropy = middle > turn ? std::sqrt((middle + turn) / (middle - turn)) : 1.0;
    relief.direction = 0.5 * std::atan2(2.0 * xy, xx - yy) * kDegrees;
    return relief;
}

void add(Relief& sum, const Relief& one, double share) {
    sum.rms += share * one.rms;
    sum.rms_about_mean += share * one.rms_about_mean;
    sum.skewness += share * one.skewness;
    sum.anisotropy += share * one.anisotropy;
    for (std::size_t i = 0; i < sum.slopes.size(); ++i) sum.slopes[i] += share * one.slopes[i];
}

Relief relief_of_parts(const ElevationModel& bed, int max_side) {
    const std::array<int, 2>& samples = bed.domain.samples;
    const Relief whole = relief_of(bed.domain, bed.heights);
    if (std::max(samples[0], samples[1]) <= max_side) return whole;
    constexpr int kParts = 3;  // along each side
    Domain part = bed.domain;
    for (std::size_t axis = 0; axis < 2; ++axis) {
        part.samples[axis] = std::min(samples[axis], max_side);
        part.size[axis] = bed.domain.step(axis) * (part.samples[axis] - 1);
    }
    Relief mean;
    mean.anisotropy = 0.0;
    for (int p = 0; p < kParts * kParts; ++p) {
        const int left = (samples[0] - part.samples[0]) * (p % kParts) / (kParts - 1);
        const int low = (samples[1] - part.samples[1]) * (p / kParts) / (kParts - 1);
        std::vector<float> heights;
        heights.reserve(part.count());
        for (int j = low; j < low + part.samples[1]; ++j) {
            const auto row = bed.heights.begin() + std::ptrdiff_t{j} * samples[0] + left;
            heights.insert(heights.end(), row, row + part.samples[0]);
        }
        add(mean, relief_of(part, heights), 1.0 / (kParts * kParts));
    }
    mean.direction = whole.direction;
    return mean;
}

}  // namespace ocean
