// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Splines of grids; see spline_grid.hpp.
#include "land/spline_grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace ocean {
namespace {

/// Coefficients that a place needs beyond its own: one before and two after it.
constexpr int kBefore = 1, kAfter = 2;
constexpr int kMinHalvedSide = 32;

constexpr double kPole = -0.26794919243112270647;  // sqrt(3) - 2
/// After this many samples the pole's power is 1e-18.
constexpr int kReach = 32;

/// Returns the index of a sample at or beyond the ends of a line of n samples.
int inside(int i, int n, bool wraps) {
    if (wraps) return ((i % n) + n) % n;
    const int period = 2 * (n - 1);
    const int folded = ((i % period) + period) % period;
    return folded < n ? folded : period - folded;
}

/// Replaces samples of a line by the coefficients of the spline through them.
void filter_line(std::span<double> line, bool wraps) {
    const int n = static_cast<int>(line.size());
    const auto at = [&](int i) -> double& { return line[static_cast<std::size_t>(i)]; };
    double sum = 0.0, power = 1.0;
    for (int k = 0; k < kReach; ++k) {
        sum += power * at(inside(-k, n, wraps));
        power *= kPole;
    }
    at(0) = 6.0 * sum;
    for (int i = 1; i < n; ++i) at(i) = 6.0 * at(i) + kPole * at(i - 1);
    if (wraps) {
        sum = 0.0;
        power = 1.0;
        for (int k = 0; k < kReach; ++k) {
            sum += power * at(inside(n - 1 + k, n, true));
            power *= kPole;
        }
        at(n - 1) = -kPole * sum;
    } else {
        at(n - 1) = kPole / (kPole * kPole - 1.0) * (at(n - 1) + kPole * at(n - 2));
    }
    for (int i = n - 2; i >= 0; --i) at(i) = kPole * (at(i + 1) - at(i));
}

/// Weights of the four coefficients around a place of a cell, and of their derivative.
struct Weights {
    std::array<double, 4> value, slope;

    explicit Weights(double t) {
        const double s = 1.0 - t;
        value = {s * s * s / 6.0, (4.0 - 6.0 * t * t + 3.0 * t * t * t) / 6.0,
                 (1.0 + 3.0 * t + 3.0 * t * t - 3.0 * t * t * t) / 6.0, t * t * t / 6.0};
        slope = {-0.5 * s * s, 0.5 * t * (3.0 * t - 4.0), 0.5 * (1.0 + 2.0 * t - 3.0 * t * t),
                 0.5 * t * t};
    }
};

double sum_of(const std::array<double, 4>& weights, const float* values) {
    return weights[0] * static_cast<double>(values[0]) +
           weights[1] * static_cast<double>(values[1]) +
           weights[2] * static_cast<double>(values[2]) +
           weights[3] * static_cast<double>(values[3]);
}

std::size_t padded(int samples) {
    return static_cast<std::size_t>(samples + kBefore + kAfter);
}

}  // namespace

SplineGrid::SplineGrid(const Domain& domain, std::span<const float> samples, ThreadPool& pool)
    : domain_(domain),
      per_metre_{1.0 / domain.step(0), 1.0 / domain.step(1)},
      pitch_(padded(domain.samples[0])),
      coefficients_(padded(domain.samples[0]) * padded(domain.samples[1])) {
    const int columns = domain.samples[0], rows = domain.samples[1];
    const auto row_of = [&](int j) {
        return coefficients_.data() + static_cast<std::size_t>(j + kBefore) * pitch_;
    };
    pool.for_each_range(rows, [&](int first, int last) {
        std::vector<double> line(static_cast<std::size_t>(columns));
        for (int j = first; j < last; ++j) {
            const auto from = samples.subspan(static_cast<std::size_t>(j) * line.size());
            std::copy_n(from.begin(), line.size(), line.begin());
            filter_line(line, domain_.wraps);
            float* const to = row_of(j);
            for (int i = -kBefore; i < columns + kAfter; ++i) {
                to[i + kBefore] = static_cast<float>(
                    line[static_cast<std::size_t>(inside(i, columns, domain_.wraps))]);
            }
        }
    });
    // Columns in bands, each of which stays in the cache.
    constexpr int kBand = 16;
    const int width = static_cast<int>(pitch_);
    pool.for_each_range((width + kBand - 1) / kBand, [&](int first, int last) {
        std::array<std::vector<double>, kBand> lines;
        for (auto& line : lines) line.resize(static_cast<std::size_t>(rows));
        for (int band = first; band < last; ++band) {
            const int begin = band * kBand, count = std::min(kBand, width - begin);
            for (int j = 0; j < rows; ++j) {
                for (int i = 0; i < count; ++i) {
                    lines[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] =
                        static_cast<double>(row_of(j)[begin + i]);
                }
            }
            for (int i = 0; i < count; ++i) {
                filter_line(lines[static_cast<std::size_t>(i)], domain_.wraps);
            }
            for (int j = -kBefore; j < rows + kAfter; ++j) {
                const auto from = static_cast<std::size_t>(inside(j, rows, domain_.wraps));
                for (int i = 0; i < count; ++i) {
                    row_of(j)[begin + i] =
                        static_cast<float>(lines[static_cast<std::size_t>(i)][from]);
                }
            }
        }
    });
}

SplineGrid::Place SplineGrid::place(double x, double y) const {
    std::array<double, 2> at = {(x - domain_.origin[0]) * per_metre_[0],
                                (y - domain_.origin[1]) * per_metre_[1]};
    std::array<std::size_t, 2> cell{};
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const double n = domain_.samples[axis];
        double& u = at[axis];
        if (domain_.wraps) {
            u -= n * std::floor(u / n);
            if (u >= n) u = 0.0;  // -1e-20 rounds up to n
        } else {
            u = std::clamp(u, 0.0, n - 1.0);
        }
        cell[axis] = static_cast<std::size_t>(u);
        u -= static_cast<double>(cell[axis]);
    }
    return {coefficients_.data() + cell[1] * pitch_ + cell[0], at[0], at[1]};
}

GroundJet SplineGrid::at(double x, double y) const {
    const auto [corner, u, v] = place(x, y);
    const Weights along(u), across(v);
    GroundJet jet;
    for (std::size_t q = 0; q < 4; ++q) {
        const float* const row = corner + q * pitch_;
        const double value = sum_of(along.value, row);
        jet.height += across.value[q] * value;
        jet.slope_y += across.slope[q] * value;
        jet.slope_x += across.value[q] * sum_of(along.slope, row);
    }
    jet.slope_x *= per_metre_[0];
    jet.slope_y *= per_metre_[1];
    return jet;
}

double SplineGrid::value_at(double x, double y) const {
    const auto [corner, u, v] = place(x, y);
    const Weights along(u), across(v);
    double height = 0.0;
    for (std::size_t q = 0; q < 4; ++q) {
        height += across.value[q] * sum_of(along.value, corner + q * pitch_);
    }
    return height;
}

std::size_t SplineGrid::bytes(const Domain& domain) {
    return padded(domain.samples[0]) * padded(domain.samples[1]) * sizeof(float);
}

Domain halved(const Domain& domain) {
    Domain half = domain;
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const int n = domain.samples[axis];
        half.samples[axis] = domain.wraps ? n / 2 : (n + 1) / 2;
        if (!domain.wraps) half.size[axis] = 2.0 * domain.step(axis) * (half.samples[axis] - 1);
    }
    return half;
}

std::vector<float> halved(const Domain& domain, std::span<const float> samples, ThreadPool& pool) {
    constexpr std::array<double, 7> kFilter = {-1.0 / 32.0, 0.0, 9.0 / 32.0, 16.0 / 32.0,
                                               9.0 / 32.0,  0.0, -1.0 / 32.0};
    constexpr int kHalf = 3;
    const Domain half = halved(domain);
    const int columns = domain.samples[0], rows = domain.samples[1];
    const int new_columns = half.samples[0], new_rows = half.samples[1];
    std::vector<float> result(half.count());
    pool.for_each_range(new_rows, [&](int first, int last) {
        std::vector<double> line(static_cast<std::size_t>(columns));
        for (int j = first; j < last; ++j) {
            std::ranges::fill(line, 0.0);
            for (int q = -kHalf; q <= kHalf; ++q) {
                const double weight = kFilter[static_cast<std::size_t>(q + kHalf)];
                if (weight == 0.0) continue;
                const auto row = static_cast<std::size_t>(inside(2 * j + q, rows, domain.wraps));
                const float* const from = samples.data() + row * line.size();
                for (std::size_t i = 0; i < line.size(); ++i) {
                    line[i] += weight * static_cast<double>(from[i]);
                }
            }
            for (int i = 0; i < new_columns; ++i) {
                double sum = 0.0;
                for (int q = -kHalf; q <= kHalf; ++q) {
                    sum += kFilter[static_cast<std::size_t>(q + kHalf)] *
                           line[static_cast<std::size_t>(inside(2 * i + q, columns, domain.wraps))];
                }
                result[static_cast<std::size_t>(j) * static_cast<std::size_t>(new_columns) +
                       static_cast<std::size_t>(i)] = static_cast<float>(sum);
            }
        }
    });
    return result;
}

namespace {

bool can_be_halved(const Domain& domain) {
    const auto [columns, rows] = domain.samples;
    if (std::min(columns, rows) < kMinHalvedSide) return false;
    return !domain.wraps || (columns % 2 == 0 && rows % 2 == 0);
}

}  // namespace

std::vector<float> decimated(const Domain& domain, std::span<const float> samples) {
    const Domain half = halved(domain);
    std::vector<float> result;
    result.reserve(half.count());
    for (int j = 0; j < half.samples[1]; ++j) {
        for (int i = 0; i < half.samples[0]; ++i) {
            result.push_back(samples[static_cast<std::size_t>(2 * j) *
                                         static_cast<std::size_t>(domain.samples[0]) +
                                     static_cast<std::size_t>(2 * i)]);
        }
    }
    return result;
}

SplinePyramid::SplinePyramid(const Domain& domain, std::span<const float> samples, ThreadPool& pool,
                             int oversampled) {
    levels_.emplace_back(domain, samples, pool);
    Domain at = domain;
    std::vector<float> coarse;
    while (can_be_halved(at)) {
        const std::span<const float> finer = coarse.empty() ? samples : std::span(coarse);
        coarse = oversampled-- > 0 ? decimated(at, finer) : halved(at, finer, pool);
        at = halved(at);
        levels_.emplace_back(at, coarse, pool);
    }
}

const SplineGrid& SplinePyramid::level(double cell) const {
    std::size_t chosen = 0;
    while (chosen + 1 < levels_.size()) {
        const Domain& next = levels_[chosen + 1].domain();
        constexpr double kRounding = 1.0 + 1e-9;
        if (std::max(next.step(0), next.step(1)) > kRounding * cell) break;
        ++chosen;
    }
    return levels_[chosen];
}

std::size_t SplinePyramid::bytes(const Domain& domain) {
    std::size_t sum = 0;
    for (Domain at = domain;; at = halved(at)) {
        sum += SplineGrid::bytes(at);
        if (!can_be_halved(at)) return sum;
    }
}

}  // namespace ocean
