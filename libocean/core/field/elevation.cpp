// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Facts and repairs of elevation models: see elevation.hpp.
#include "ocean/internal/elevation.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "ocean/error.hpp"
#include "ocean/internal/grid.hpp"

namespace ocean {
namespace {

/// A view of heights with its sides.
struct HeightGrid {
    std::span<float> heights;
    int columns;
    int rows;

    float& at(int i, int j) const {
        return heights[static_cast<std::size_t>(j) * static_cast<std::size_t>(columns) +
                       static_cast<std::size_t>(i)];
    }
};

bool has_holes(std::span<const float> heights) {
    return std::ranges::any_of(heights, [](float h) { return std::isnan(h); });
}

/// Returns the means of the known heights in squares of 2 x 2 samples; NaN where none is known.
std::vector<float> coarser(const HeightGrid& fine, int columns, int rows) {
    std::vector<float> means;
    means.reserve(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
    for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < columns; ++i) {
            double sum = 0.0;
            int known = 0;
            for (int y = 2 * j; y < std::min(2 * j + 2, fine.rows); ++y) {
                for (int x = 2 * i; x < std::min(2 * i + 2, fine.columns); ++x) {
                    const float h = fine.at(x, y);
                    if (std::isnan(h)) continue;
                    sum += double{h};
                    ++known;
                }
            }
            means.push_back(static_cast<float>(sum / known));  // 0 / 0 is NaN
        }
    }
    return means;
}

/// Returns the coarse heights, bilinear, at a sample of the grid that is twice as fine.
float interpolated(const HeightGrid& coarse, int i, int j) {
    const auto neighbour = [](int fine, int count) {
        return std::clamp(fine / 2 + (fine % 2 == 0 ? -1 : 1), 0, count - 1);
    };
    const int x = i / 2, y = j / 2;
    const int x1 = neighbour(i, coarse.columns), y1 = neighbour(j, coarse.rows);
    const auto along = [&](int row) {
        return 0.75f * coarse.at(x, row) + 0.25f * coarse.at(x1, row);
    };
    return 0.75f * along(y) + 0.25f * along(y1);
}

/// Fills holes with the means of coarser and coarser heights, a first guess of the smooth surface.
void guess_holes(const HeightGrid& grid) {
    if (!has_holes(grid.heights)) return;
    const int columns = (grid.columns + 1) / 2, rows = (grid.rows + 1) / 2;
    std::vector<float> means = coarser(grid, columns, rows);
    const HeightGrid coarse{means, columns, rows};
    guess_holes(coarse);
    for (int j = 0; j < grid.rows; ++j) {
        for (int i = 0; i < grid.columns; ++i) {
            if (std::isnan(grid.at(i, j))) grid.at(i, j) = interpolated(coarse, i, j);
        }
    }
}

/// Returns the mean of the up to four neighbours of a sample.
double mean_of_neighbours(const HeightGrid& grid, int i, int j) {
    double sum = 0.0;
    int count = 0;
    const auto add = [&](int x, int y) {
        if (x < 0 || y < 0 || x >= grid.columns || y >= grid.rows) return;
        sum += double{grid.at(x, y)};
        ++count;
    };
    add(i - 1, j);
    add(i + 1, j);
    add(i, j - 1);
    add(i, j + 1);
    return sum / count;
}

/// Turns the guess into the solution of Laplace's equation by successive over-relaxation.
void relax(const HeightGrid& grid, std::span<const std::uint64_t> holes) {
    constexpr double kOverRelaxation = 1.85;  // optimal for holes of 40 samples
    constexpr std::size_t kMaxUpdates = 2'000'000'000;
    constexpr double kFineEnough = 1e-4;  // the largest change of a sweep [m]
    const std::size_t sweeps = std::clamp<std::size_t>(kMaxUpdates / holes.size(), 20, 1000);
    for (std::size_t sweep = 0; sweep < sweeps; ++sweep) {
        double change = 0.0;
        for (const std::uint64_t hole : holes) {
            const int i = static_cast<int>(hole % static_cast<std::uint64_t>(grid.columns));
            const int j = static_cast<int>(hole / static_cast<std::uint64_t>(grid.columns));
            const double step =
                kOverRelaxation * (mean_of_neighbours(grid, i, j) - double{grid.heights[hole]});
            grid.heights[hole] = static_cast<float>(double{grid.heights[hole]} + step);
            change = std::max(change, std::abs(step));
        }
        if (change < kFineEnough) return;
    }
}

/// The samples whose weighted mean is one sample of another grid, along a side.
struct Taps {
    std::size_t first = 0;
    std::vector<double> weights;  // their sum is 1
};

/// Returns the integral of the hat function 1 - |t|, which is 0 beyond |t| = 1, from -1 to `t`.
double hat_integral(double t) {
    const double inside = std::clamp(t, -1.0, 1.0);
    const double rest = 1.0 - std::abs(inside);
    return inside < 0.0 ? 0.5 * rest * rest : 1.0 - 0.5 * rest * rest;
}

/// Returns the taps of each sample of `to` along a side: the mean of the linear interpolant over
/// the sample's cell, which the borders of `from` cut equally on both sides.
std::vector<Taps> mean_taps(const Domain& from, const Domain& to, int side) {
    const auto axis = static_cast<std::size_t>(side);
    const int last = from.samples[axis] - 1;
    const double cell = to.step(axis) / from.step(axis);
    std::vector<Taps> taps(static_cast<std::size_t>(to.samples[axis]));
    for (std::size_t i = 0; i < taps.size(); ++i) {
        const double place = std::min(static_cast<double>(i) * cell, static_cast<double>(last));
        // An interval without length counts as a point: one as short as this changes no float.
        const double half = std::max(1e-6, std::min({0.5 * cell, place, last - place}));
        const int begin = std::clamp(static_cast<int>(std::floor(place - half)), 0, last);
        const int end = std::clamp(static_cast<int>(std::ceil(place + half)), begin, last);
        taps[i].first = static_cast<std::size_t>(begin);
        double sum = 0.0;
        for (int k = begin; k <= end; ++k) {
            const double weight = hat_integral(place + half - k) - hat_integral(place - half - k);
            taps[i].weights.push_back(weight);
            sum += weight;
        }
        for (double& weight : taps[i].weights) weight /= sum;
    }
    return taps;
}

}  // namespace

ElevationSummary summarize(const ElevationModel& model) {
    ElevationSummary summary;
    double sum = 0.0, squares = 0.0;
    std::size_t known = 0;
    for (const float h : model.heights) {
        if (std::isnan(h)) continue;
        summary.lowest = known == 0 ? h : std::min(summary.lowest, h);
        summary.highest = known == 0 ? h : std::max(summary.highest, h);
        sum += double{h};
        squares += double{h} * double{h};
        ++known;
    }
    summary.holes = model.heights.size() - known;
    if (known == 0) return summary;
    const double count = static_cast<double>(known);
    summary.mean = sum / count;
    summary.rms = std::sqrt(std::max(0.0, squares / count - summary.mean * summary.mean));
    return summary;
}

ElevationModel with_square_cells(const ElevationModel& model, double cell) {
    const Domain& given = model.domain;
    ElevationModel square = model;
    square.domain = domain_of({.origin = given.origin, .size = given.size, .cell = cell});
    const auto [columns, rows] = square.domain.samples;
    const std::vector<Taps> across = mean_taps(given, square.domain, 0);
    const std::vector<Taps> along = mean_taps(given, square.domain, 1);
    const auto width = static_cast<std::size_t>(columns);
    square.heights = PageVector<float>(width * static_cast<std::size_t>(rows));
    std::vector<double> sums(static_cast<std::size_t>(given.samples[0]));
    for (int j = 0; j < rows; ++j) {
        std::ranges::fill(sums, 0.0);
        const Taps& lines = along[static_cast<std::size_t>(j)];
        for (std::size_t n = 0; n < lines.weights.size(); ++n) {
            const std::size_t start = (lines.first + n) * sums.size();
            for (std::size_t i = 0; i < sums.size(); ++i) {
                sums[i] += lines.weights[n] * double{model.heights[start + i]};
            }
        }
        for (std::size_t i = 0; i < width; ++i) {
            const Taps& taps = across[i];
            double height = 0.0;
            for (std::size_t n = 0; n < taps.weights.size(); ++n) {
                height += taps.weights[n] * sums[taps.first + n];
            }
            square.heights[static_cast<std::size_t>(j) * width + i] = static_cast<float>(height);
        }
    }
    return square;
}

std::array<double, 2> metres_per_degree(double latitude) {
    constexpr double kSemiMajorAxis = 6378137.0;         // a [m]
    constexpr double kFlattening = 1.0 / 298.257223563;  // f
    constexpr double kSquaredEccentricity = kFlattening * (2.0 - kFlattening);
    const double sine = std::sin(latitude * kDegree);
    const double w = 1.0 - kSquaredEccentricity * sine * sine;
    // The radii of curvature: of the parallel N cos(latitude), N = a / sqrt(w); of the meridian
    // M = a (1 - e^2) / w^1.5.
    const double normal = kSemiMajorAxis / std::sqrt(w);
    return {normal * std::cos(latitude * kDegree) * kDegree,
            normal * (1.0 - kSquaredEccentricity) / w * kDegree};
}

void scale_degrees(ElevationModel& model) {
    const Domain degrees = model.domain;
    const double north = degrees.origin[1] + degrees.size[1];
    const double half_cell = 0.5 * degrees.step(1);
    if (degrees.origin[1] - half_cell < -90.0 - 1e-6 || north + half_cell > 90.0 + 1e-6) {
        throw Error(
            ErrorKind::invalid_value,
            "cells of degrees reach beyond a pole: the latitudes must lie within -90 .. 90");
    }
    const std::array<double, 2> metres = metres_per_degree(0.5 * (degrees.origin[1] + north));
    model.was_degrees = true;
    model.geographic_origin = degrees.origin;
    model.geographic_cell = {degrees.step(0), degrees.step(1)};
    model.domain.origin = {0.0, 0.0};
    model.domain.size = {degrees.size[0] * metres[0], degrees.size[1] * metres[1]};
}

void fill_holes(std::span<float> heights, int columns) {
    std::vector<std::uint64_t> holes;
    for (std::size_t i = 0; i < heights.size(); ++i) {
        if (std::isnan(heights[i])) holes.push_back(i);
    }
    if (holes.empty()) return;
    if (holes.size() == heights.size()) {
        throw Error(ErrorKind::invalid_value, "all heights are holes: none can be filled");
    }
    const int rows = static_cast<int>(heights.size() / static_cast<std::size_t>(columns));
    const HeightGrid grid{heights, columns, rows};
    guess_holes(grid);
    relax(grid, holes);
}

}  // namespace ocean
