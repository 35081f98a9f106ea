// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Splines of grids; see spline_grid.hpp.
#include "field/spline_grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "field/cubic.hpp"

namespace ocean {
namespace {

/// Coefficients that a place needs beside its own: one before and two after it.
constexpr int kBefore = 1, kAfter = 2;
constexpr int kMinHalvedSide = 32;

constexpr double kPole = -0.26794919243112270647;  // sqrt(3) - 2
/// After this many samples the pole's power is 1e-18.
constexpr int kReach = 32;

/// Returns the sample, on a line of n samples, of an index that may lie beyond the ends: wrapped or
/// mirrored.
int inside(int i, int n, bool wraps) {
    if (wraps) return ((i % n) + n) % n;
    const int period = 2 * (n - 1);
    const int folded = ((i % period) + period) % period;
    return folded < n ? folded : period - folded;
}

/// The number of neighbouring lines that are filtered together: each in its own order, so that its
/// bits do not depend on the others.
constexpr int kSplineLanes = 8;
using Lanes = std::array<double, kSplineLanes>;

/// Returns the sum of power^k times the samples from `first` on, towards `step`.
Lanes tail_of(std::span<const Lanes> line, int first, int step, bool wraps) {
    Lanes sum{};
    double power = 1.0;
    for (int k = 0; k < kReach; ++k) {
        const int i = inside(first + step * k, static_cast<int>(line.size()), wraps);
        const Lanes& sample = line[static_cast<std::size_t>(i)];
        for (std::size_t l = 0; l < kSplineLanes; ++l) sum[l] += power * sample[l];
        power *= kPole;
    }
    return sum;
}

/// Replaces samples of lines by the coefficients of the splines through the samples.
void filter_lines(std::span<Lanes> line, bool wraps) {
    Lanes last = tail_of(line, 0, -1, wraps);
    for (double& value : last) value *= 6.0;
    line.front() = last;
    for (Lanes& sample : line.subspan(1)) {
        for (std::size_t l = 0; l < kSplineLanes; ++l) last[l] = 6.0 * sample[l] + kPole * last[l];
        sample = last;
    }
    const auto end = static_cast<int>(line.size()) - 1;
    if (wraps) {
        last = tail_of(line, end, 1, true);
        for (double& value : last) value *= -kPole;
    } else {
        const Lanes& before = line[line.size() - 2];
        for (std::size_t l = 0; l < kSplineLanes; ++l) {
            last[l] = kPole / (kPole * kPole - 1.0) * (last[l] + kPole * before[l]);
        }
    }
    line.back() = last;
    for (auto i = line.size() - 1; i-- > 0;) {
        for (std::size_t l = 0; l < kSplineLanes; ++l) last[l] = kPole * (last[l] - line[i][l]);
        line[i] = last;
    }
}

double sum_of(const std::array<double, 4>& weights, const float* values) {
    return weights[0] * static_cast<double>(values[0]) +
           weights[1] * static_cast<double>(values[1]) +
           weights[2] * static_cast<double>(values[2]) +
           weights[3] * static_cast<double>(values[3]);
}

std::size_t padded(int samples) {
    return static_cast<std::size_t>(samples + kBefore + kAfter);
}

/// Returns the length of a row of coefficients, in whole lanes.
std::size_t pitch_of(const Domain& domain) {
    return (padded(domain.samples[0]) + kSplineLanes - 1) / kSplineLanes * kSplineLanes;
}

}  // namespace

SplineGrid::SplineGrid(const Domain& domain, std::span<const float> samples, ThreadPool& pool)
    : domain_(domain),
      per_metre_{1.0 / domain.step(0), 1.0 / domain.step(1)},
      pitch_(pitch_of(domain)),
      coefficients_(pitch_ * padded(domain.samples[1])) {
    filter_rows(samples, pool);
    filter_columns(pool);
}

/// Writes the filtered rows of the samples, with the coefficients beyond both ends.
void SplineGrid::filter_rows(std::span<const float> samples, ThreadPool& pool) {
    const int columns = domain_.samples[0], rows = domain_.samples[1];
    const auto width = static_cast<std::size_t>(columns);
    pool.for_each_range((rows + kSplineLanes - 1) / kSplineLanes, [&](int first, int last) {
        std::vector<Lanes> lines(width);
        for (int begin = first * kSplineLanes; begin < std::min(last * kSplineLanes, rows);
             begin += kSplineLanes) {
            const int end = std::min(begin + kSplineLanes, rows);
            std::array<const float*, kSplineLanes> from{};
            for (int l = 0; l < kSplineLanes; ++l) {
                const int j = std::min(begin + l, end - 1);
                from[static_cast<std::size_t>(l)] =
                    samples.data() + static_cast<std::size_t>(j) * width;
            }
            for (std::size_t i = 0; i < width; ++i) {
                for (std::size_t l = 0; l < kSplineLanes; ++l) {
                    lines[i][l] = static_cast<double>(from[l][i]);
                }
            }
            filter_lines(lines, domain_.wraps);
            for (int j = begin; j < end; ++j) {
                const auto l = static_cast<std::size_t>(j - begin);
                float* const to = row(j) + kBefore;
                for (std::size_t i = 0; i < width; ++i) to[i] = static_cast<float>(lines[i][l]);
                for (const int i : {-1, columns, columns + 1}) {
                    to[i] = to[inside(i, columns, domain_.wraps)];
                }
                std::fill(to + columns + kAfter, row(j) + pitch_, 0.0f);
            }
        }
    });
}

/// Filters the columns, and adds the rows beyond both ends.
void SplineGrid::filter_columns(ThreadPool& pool) {
    const int rows = domain_.samples[1];
    pool.for_each_range(static_cast<int>(pitch_) / kSplineLanes, [&](int first, int last) {
        std::vector<Lanes> lines(static_cast<std::size_t>(rows));
        for (int begin = first * kSplineLanes; begin < last * kSplineLanes; begin += kSplineLanes) {
            for (int j = 0; j < rows; ++j) {
                std::copy_n(row(j) + begin, kSplineLanes,
                            lines[static_cast<std::size_t>(j)].begin());
            }
            filter_lines(lines, domain_.wraps);
            for (int j = -kBefore; j < rows + kAfter; ++j) {
                float* const to = row(j) + begin;
                const auto from = static_cast<std::size_t>(inside(j, rows, domain_.wraps));
                for (std::size_t l = 0; l < kSplineLanes; ++l)
                    to[l] = static_cast<float>(lines[from][l]);
            }
        }
    });
}

/// Returns row j of the coefficients, -1 .. rows + 1.
float* SplineGrid::row(int j) {
    return coefficients_.data() + static_cast<std::size_t>(j + kBefore) * pitch_;
}

SplineGrid::InCell SplineGrid::in_cell(double at, std::size_t axis) const {
    const double n = domain_.samples[axis];
    double u = (at - domain_.origin[axis]) * per_metre_[axis];
    if (domain_.wraps) {
        u -= n * std::floor(u / n);
        if (u >= n) u = 0.0;  // -1e-20 rounds up to n
    } else {
        u = std::clamp(u, 0.0, n - 1.0);
    }
    const auto cell = static_cast<std::size_t>(u);
    return {cell, u - static_cast<double>(cell)};
}

GroundJet SplineGrid::at(double x, double y) const {
    const auto [i, u] = in_cell(x, 0);
    const auto [j, v] = in_cell(y, 1);
    const float* const corner = coefficients_.data() + j * pitch_ + i;
    const std::array<double, 4> along = b_spline(u), along_slopes = b_spline_slopes(u);
    const std::array<double, 4> across = b_spline(v), across_slopes = b_spline_slopes(v);
    GroundJet jet;
    for (std::size_t q = 0; q < 4; ++q) {
        const float* const row = corner + q * pitch_;
        const double value = sum_of(along, row);
        jet.height += across[q] * value;
        jet.slope_y += across_slopes[q] * value;
        jet.slope_x += across[q] * sum_of(along_slopes, row);
    }
    jet.slope_x *= per_metre_[0];
    jet.slope_y *= per_metre_[1];
    return jet;
}

double SplineGrid::value_at(double x, double y) const {
    double height = 0.0;
    values_at({&x, 1}, {&y, 1}, {&height, 1});
    return height;
}

void SplineGrid::values_at(std::span<const double> x, std::span<const double> y,
                           std::span<double> heights) const {
    std::array<double, 4> across{};
    const float* line = nullptr;  // the first of the four rows around y
    for (std::size_t n = 0; n < x.size(); ++n) {
        if (n == 0 || y[n] != y[n - 1]) {
            const auto [j, v] = in_cell(y[n], 1);
            across = b_spline(v);
            line = coefficients_.data() + j * pitch_;
        }
        const auto [i, u] = in_cell(x[n], 0);
        const std::array<double, 4> along = b_spline(u);
        double height = 0.0;
        for (std::size_t q = 0; q < 4; ++q) {
            height += across[q] * sum_of(along, line + q * pitch_ + i);
        }
        heights[n] = height;
    }
}

std::size_t SplineGrid::bytes(const Domain& domain) {
    return pitch_of(domain) * padded(domain.samples[1]) * sizeof(float);
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

namespace {

constexpr std::array<double, 7> kFilter = {-1.0 / 32.0, 0.0, 9.0 / 32.0, 16.0 / 32.0,
                                           9.0 / 32.0,  0.0, -1.0 / 32.0};

/// Returns the sum of kFilter times the samples 0 .. 6 of a function.
template <typename Sample>
double filtered(const Sample& sample) {
    double sum = 0.0;
    for (const std::size_t q : {0u, 2u, 3u, 4u, 6u}) sum += kFilter[q] * sample(q);
    return sum;
}

}  // namespace

std::vector<float> halved(const Domain& domain, std::span<const float> samples, ThreadPool& pool) {
    const Domain half = halved(domain);
    const int columns = domain.samples[0], rows = domain.samples[1];
    const auto width = static_cast<std::size_t>(columns);
    const auto new_width = static_cast<std::size_t>(half.samples[0]);
    std::vector<float> result(half.count());
    pool.for_each_range(half.samples[1], [&](int first, int last) {
        std::vector<double> padded_line(width + 2 * kHalvingReach);
        double* const line = padded_line.data() + kHalvingReach;
        for (int j = first; j < last; ++j) {
            std::array<const float*, kFilter.size()> row{};
            for (int q = -kHalvingReach; q <= kHalvingReach; ++q) {
                row[static_cast<std::size_t>(q + kHalvingReach)] =
                    samples.data() +
                    static_cast<std::size_t>(inside(2 * j + q, rows, domain.wraps)) * width;
            }
            for (std::size_t i = 0; i < width; ++i) {
                line[i] = filtered([&](std::size_t q) { return static_cast<double>(row[q][i]); });
            }
            for (int q = 1; q <= kHalvingReach; ++q) {
                line[-q] = line[inside(-q, columns, domain.wraps)];
                line[columns - 1 + q] = line[inside(columns - 1 + q, columns, domain.wraps)];
            }
            float* const to = result.data() + static_cast<std::size_t>(j) * new_width;
            for (std::size_t i = 0; i < new_width; ++i) {
                const double* const from = padded_line.data() + 2 * i;
                to[i] = static_cast<float>(filtered([&](std::size_t q) { return from[q]; }));
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

std::size_t SplinePyramid::index(double cell) const {
    std::size_t chosen = 0;
    while (chosen + 1 < levels_.size()) {
        const Domain& next = levels_[chosen + 1].domain();
        constexpr double kRounding = 1.0 + 1e-9;
        if (std::max(next.step(0), next.step(1)) > kRounding * cell) break;
        ++chosen;
    }
    return chosen;
}

std::size_t SplinePyramid::bytes(const Domain& domain) {
    std::size_t sum = 0;
    for (Domain at = domain;; at = halved(at)) {
        sum += SplineGrid::bytes(at);
        if (!can_be_halved(at)) return sum;
    }
}

}  // namespace ocean
